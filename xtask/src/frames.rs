//! The deepest stack of a program, summed: the size of every function's frame, along the calls that the linker saw.
//!
//! The compiler writes the frame sizes (`-Z emit-stack-sizes`), the linker keeps its relocations (`--emit-relocs`): a
//! relocation in the code of one function that names another is a call, a jump, or an address that may be called later. The
//! deepest sum is an upper bound whatever the input, where a painted stack shows one run.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{bail, Context, Result};
use object::{Object, ObjectSection, ObjectSymbol, RelocationKind, RelocationTarget, SymbolKind};

/// A function: the bytes of its frame, and those that it calls.
#[derive(Debug, Default)]
struct Function {
    name: String,
    end: u64,
    frame: u64,
    calls: Vec<u64>,
}

/// The functions of a program by their addresses.
type Graph = BTreeMap<u64, Function>;

/// Bytes of stack of the deepest chain of calls from `main`.
pub fn deepest(elf: &Path) -> Result<u64> {
    let bytes = fs::read(elf).with_context(|| format!("reading {}", elf.display()))?;
    let graph = graph(&object::File::parse(&*bytes)?)?;
    let main = graph.iter().find(|(_, function)| function.name == "main").map(|(&address, _)| address);
    let main = main.with_context(|| format!("{} has no main", elf.display()))?;
    sum(&graph, main, &mut Vec::new(), &mut BTreeMap::new()).with_context(|| format!("the calls of {}", elf.display()))
}

/// Bit 0 of the address of a Thumb function is not part of the address.
fn even(address: u64) -> u64 {
    address & !1
}

fn graph(file: &object::File<'_>) -> Result<Graph> {
    let mut graph = Graph::new();
    for symbol in file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0) {
        let start = even(symbol.address());
        let function = graph.entry(start).or_default();
        function.end = start + symbol.size();
        // Of several names for the same code the one that is looked for.
        if function.name != "main" {
            symbol.name()?.clone_into(&mut function.name);
        }
    }
    let sizes =
        file.section_by_name(".stack_sizes").context("no frame sizes: was it built with -Z emit-stack-sizes?")?;
    for (address, size) in frame_sizes(sizes.data()?)? {
        graph.entry(even(address)).or_default().frame = size;
    }
    let text = file.section_by_name(".text").context("no code")?;
    for (at, relocation) in text.relocations() {
        let RelocationTarget::Symbol(index) = relocation.target() else { continue };
        let symbol = file.symbol_by_index(index)?;
        // The offset of an image's relocation is an address. A table of jumps names a section: where in it, is what stands there.
        let entry = match (symbol.kind(), relocation.kind()) {
            (SymbolKind::Section, RelocationKind::Absolute) => word(text.address(), text.data()?, at),
            _ => None,
        };
        let target = even(entry.unwrap_or_else(|| symbol.address()));
        let Some((&caller, _)) = graph.range(..=at).next_back().filter(|(_, f)| at < f.end) else { continue };
        if caller != target && graph.contains_key(&target) {
            graph.entry(caller).and_modify(|function| function.calls.push(target));
        }
    }
    Ok(graph)
}

/// The 32 bits at an address of a section.
fn word(start: u64, data: &[u8], at: u64) -> Option<u64> {
    let bytes = data.get(usize::try_from(at.checked_sub(start)?).ok()?..)?.first_chunk()?;
    Some(u32::from_le_bytes(*bytes).into())
}

/// Pairs of a 32-bit address and a size in LEB128.
fn frame_sizes(mut bytes: &[u8]) -> Result<Vec<(u64, u64)>> {
    let mut sizes = Vec::new();
    while let Some((address, rest)) = bytes.split_first_chunk() {
        let len = rest.iter().position(|byte| byte & 0x80 == 0).context("a frame size without end")? + 1;
        let (size, rest) = rest.split_at(len);
        let size = size.iter().rev().fold(0, |sum, byte| sum << 7 | u64::from(byte & 0x7f));
        sizes.push((u32::from_le_bytes(*address).into(), size));
        bytes = rest;
    }
    Ok(sizes)
}

fn sum(graph: &Graph, at: u64, above: &mut Vec<u64>, known: &mut BTreeMap<u64, u64>) -> Result<u64> {
    if let Some(&sum) = known.get(&at) {
        return Ok(sum);
    }
    let function = &graph[&at];
    if above.contains(&at) {
        bail!("{} calls itself", function.name);
    }
    above.push(at);
    let mut deepest = 0;
    for &call in &function.calls {
        deepest = deepest.max(sum(graph, call, above, known)?);
    }
    above.pop();
    known.insert(at, function.frame + deepest);
    Ok(function.frame + deepest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn function(name: &str, frame: u64, calls: &[u64]) -> Function {
        Function { name: name.into(), end: 0, frame, calls: calls.to_vec() }
    }

    #[test]
    fn the_deepest_chain_counts() {
        let graph = Graph::from([
            (0, function("main", 8, &[2, 4])),
            (2, function("wide", 100, &[])),
            (4, function("deep", 40, &[6, 2])),
            (6, function("deeper", 90, &[])),
        ]);
        assert_eq!(sum(&graph, 0, &mut Vec::new(), &mut BTreeMap::new()).expect("no cycle"), 8 + 40 + 100);
    }

    #[test]
    fn recursion_is_an_error() {
        let graph =
            Graph::from([(0, function("main", 8, &[2])), (2, function("a", 8, &[4])), (4, function("b", 8, &[2]))]);
        let error = sum(&graph, 0, &mut Vec::new(), &mut BTreeMap::new()).expect_err("a cycle");
        assert_eq!(error.to_string(), "a calls itself");
    }

    #[test]
    fn sizes_may_take_two_bytes() {
        let bytes = [0x10, 0, 0, 0, 0x05, 0x21, 0, 0, 0x20, 0x80, 0x02];
        assert_eq!(frame_sizes(&bytes).expect("well-formed"), [(0x10, 5), (0x2000_0021, 256)]);
        assert!(frame_sizes(&[0, 0, 0, 0, 0x80]).is_err(), "cut off");
    }
}
