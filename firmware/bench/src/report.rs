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
