//! Prints what every workload costs in this crate, in the formats of most displays: what budgets are kept of. Built in a
//! fraction of the time that the table of all engines takes.
#![no_std]
#![no_main]

use bench::scene::Scene;
use bench::{own, report};

board::entry!(main);

fn main() {
    let scene = Scene::new();
    report::header();
    report::print(&own::RGB565, &mut own::Frame::new(), &scene);
    report::print(&own::GRAY4, &mut own::Frame::new(), &scene);
}
