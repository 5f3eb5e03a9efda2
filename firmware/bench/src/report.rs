//! The table: one line per workload, format and engine.

use core::hint::black_box;

use board::counter::{count, Count};
use board::{crc32, println, stack, CHIP};

use crate::engine::Engine;
use crate::scene::{Pictures, Scene, Work, Workload};

/// Prints the names of the fields.
pub fn header() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call");
    println!("# workload;format;engine;cycles;instructions;calls;pixels;stack;crc32");
}

/// Measures everything that this engine can draw.
pub fn print<F>(engine: &Engine<F>, frame: &mut F, scene: &Scene) {
    let pictures = Pictures::new(engine.format);
    for workload in &scene.workloads(&pictures) {
        if let Some(row) = measure(engine, frame, &workload.work) {
            line(engine, workload, &row);
        }
    }
}

/// Measures something that is in no scene: its name, how many items are drawn, and how many pixels.
pub fn item<F>(engine: &Engine<F>, frame: &mut F, (name, calls, pixels): (&str, usize, usize), draw: &dyn Fn(&mut F)) {
    (engine.blacken)(frame);
    draw(frame);
    // Of the first drawing: what flips bits leaves other pixels after the second.
    let crc32 = crc32((engine.bytes)(frame));
    let mut work = || black_box(draw)(black_box(frame));
    let Count { cycles, instructions } = count(&mut work);
    let stack = stack::depth(&mut work);
    let (format, engine) = (engine.format.name(), engine.name);
    println!("{name};{format};{engine};{cycles};{instructions};{calls};{pixels};{stack};{crc32:08x}");
}

struct Row {
    count: Count,
    stack: usize,
    crc32: u32,
}

/// `None` when this engine cannot draw this.
fn measure<F>(engine: &Engine<F>, frame: &mut F, work: &Work<'_>) -> Option<Row> {
    (engine.blacken)(frame);
    engine.draw(frame, work)?;
    // Drawing is idempotent: the frame is the same after any number of runs.
    let mut draw = || _ = black_box(engine).draw(black_box(frame), black_box(work));
    let count = count(&mut draw);
    let stack = stack::depth(&mut draw);
    Some(Row { count, stack, crc32: crc32((engine.bytes)(frame)) })
}

fn line<F>(engine: &Engine<F>, workload: &Workload<'_>, row: &Row) {
    let Workload { name, calls, pixels, .. } = workload;
    let (format, engine) = (engine.format.name(), engine.name);
    let Row { count: Count { cycles, instructions }, stack, crc32 } = row;
    println!("{name};{format};{engine};{cycles};{instructions};{calls};{pixels};{stack};{crc32:08x}");
}
