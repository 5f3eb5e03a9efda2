//! Prints what text costs: in each format of small displays, of embedded-graphics on the same memory, and on a screen that is turned by
//! a quarter, with a clear beside it.
#![no_std]
#![no_main]

use bench::engine::Engine;
use bench::scene::{self, Ink, Label, Scene};
use bench::{own, report};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::Point;
use embedded_raster::surface::{Turn, Turned};
use embedded_raster::{Canvas, PixelFormat};

board::entry!(main);

fn main() {
    let scene = Scene::new();
    report::header();
    let mut frame = own::Frame::new();
    report::print(&only_text(&own::RGB565, own::RGB565.text), &mut frame, &scene);
    let mut other = only_text(&own::RGB565, Some(text_of_eg));
    other.name = "embedded-graphics on it";
    report::print(&other, &mut frame, &scene);
    let mut turned = only_text(&own::RGB565, Some(turned_text));
    turned.name = "turned by a quarter";
    turned.clear = Some(turned_clear);
    report::print(&turned, &mut frame, &scene);
    report::print(&only_text(&own::GRAY4, own::GRAY4.text), &mut own::Frame::new(), &scene);
    report::print(&only_text(&own::BINARY, own::BINARY.text), &mut own::Frame::new(), &scene);
}

/// An engine that draws text and nothing else.
fn only_text<F>(engine: &Engine<F>, text: Option<fn(&mut F, &[Label<'_>])>) -> Engine<F> {
    Engine { text, ..Engine::new(engine.name, engine.format, engine.blacken, engine.bytes) }
}

fn text_of_eg(frame: &mut own::Frame<Rgb565>, labels: &[Label<'_>]) {
    let Ok(()) = scene::text(&mut frame.surface(), labels, own::color::<Rgb565>);
}

/// A turned screen is as wide as a line is long.
fn turned_text(frame: &mut own::Frame<Rgb565>, labels: &[Label<'_>]) {
    let mut surface = frame.surface();
    let mut turned = Turned::new(&mut surface, Turn::Quarter);
    for label in labels {
        own::style::<Rgb565>(label).draw(&mut turned, Point::new(0, label.at.y), label.text);
    }
}

fn turned_clear(frame: &mut own::Frame<Rgb565>, ink: Ink) {
    Turned::new(&mut frame.surface(), Turn::Quarter).fill_window(Rgb565::unpack(ink.0.into()));
}
