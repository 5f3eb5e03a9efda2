//! Prints what everyday drawing costs: pictures, patterns, raster operations, dither and turned screens, beside embedded-graphics.
#![no_std]
#![no_main]

mod drawing;

use bench::report;
use bench::scene::Scene;
use drawing::Pictures;

board::entry!(main);

fn main() {
    report::header();
    drawing::print(&Pictures::new(), &Scene::new());
}
