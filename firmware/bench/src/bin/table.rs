//! Prints what every workload costs in every engine and format, one line each.
#![no_std]
#![no_main]

use bench::scene::{Format, Scene};
use bench::{bound, eg, own, report, soft};

board::entry!(main);

fn main() {
    let scene = Scene::new();
    report::header();
    report::print(&own::RGB565, &mut own::Frame::new(), &scene);
    report::print(&own::GRAY8, &mut own::Frame::new(), &scene);
    report::print(&own::GRAY4, &mut own::Frame::new(), &scene);
    report::print(&own::BINARY, &mut own::Frame::new(), &scene);
    report::print(&soft::RGB565, &mut soft::Frame::new(), &scene);
    report::print(&soft::GRAY8, &mut soft::Frame::new(), &scene);
    report::print(&soft::GRAY4, &mut soft::Frame::new(), &scene);
    report::print(&eg::RGB565, &mut eg::Rgb565Frame::new(), &scene);
    report::print(&eg::GRAY8, &mut eg::Gray8Frame::new(), &scene);
    report::print(&eg::GRAY4, &mut eg::Gray4Frame::new(), &scene);
    report::print(&eg::BINARY, &mut eg::BinaryFrame::new(), &scene);
    for format in [Format::Rgb565, Format::Gray8, Format::Gray4, Format::Binary] {
        report::print(&bound::engine(format), &mut bound::Frame::new(format), &scene);
    }
}
