//! Engines: ways to draw a list of shapes, each on a screen of its own.

pub(crate) mod curves;
pub(crate) mod ellipses;
pub(crate) mod floods;
pub(crate) mod lines;
pub(crate) mod memory;
pub(crate) mod outlines;
pub(crate) mod paths;
pub(crate) mod peers;
pub(crate) mod polygons;
pub(crate) mod strokes;
pub(crate) mod triangles;

use embedded_graphics::pixelcolor::{raw::RawU16, Rgb565};
use embedded_raster::{buffer_bytes, Framebuffer};

use crate::{
    frame::{Frame, Mask, HEIGHT, INK, WIDTH},
    workload::Workload,
};

/// Draws shapes of type `S`. What it leaves is of type `D`: painted pixels, mostly.
pub(crate) trait Engine<S, D = Mask> {
    fn draw(&mut self, shapes: &[S]);
    fn clear(&mut self);
    fn painted(&self) -> D;
}

/// Where an engine comes from: the colour of its mark in the plots.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    Textbook,
    Crate,
    Peer,
}

/// A row of the tables.
pub(crate) struct Entry<S, D = Mask> {
    /// Names the row on the command line of a child.
    pub(crate) key: &'static str,
    pub(crate) name: &'static str,
    pub(crate) origin: Origin,
    /// Whether it can draw the workloads that not everybody can.
    pub(crate) can_hard: bool,
    pub(crate) engine: Box<dyn Engine<S, D>>,
}

impl<S, D> Entry<S, D> {
    /// Whether it draws this workload or sits it out.
    pub(crate) fn can(&self, workload: &Workload<S>) -> bool {
        self.can_hard || !workload.hard
    }
}

pub(crate) fn entry<S, D>(
    key: &'static str,
    name: &'static str,
    origin: Origin,
    engine: impl Engine<S, D> + 'static,
) -> Entry<S, D> {
    Entry { key, name, origin, can_hard: true, engine: Box::new(engine) }
}

/// An algorithm on the plain [`Frame`].
struct Plain<F> {
    frame: Frame,
    shape: F,
}

fn plain<S>(shape: impl FnMut(&mut Frame, &S)) -> Plain<impl FnMut(&mut Frame, &S)> {
    Plain { frame: Frame::new(), shape }
}

impl<S, F: FnMut(&mut Frame, &S)> Engine<S> for Plain<F> {
    fn draw(&mut self, shapes: &[S]) {
        for shape in shapes {
            (self.shape)(&mut self.frame, shape);
        }
    }

    fn clear(&mut self) {
        self.frame.clear();
    }

    fn painted(&self) -> Mask {
        self.frame.painted()
    }
}

/// This crate as people use it: a `Canvas` on a `Framebuffer`.
struct Own<F> {
    memory: Vec<u8>,
    shape: F,
}

fn own<S>(shape: impl FnMut(&mut Framebuffer<'_, Rgb565>, &S)) -> Own<impl FnMut(&mut Framebuffer<'_, Rgb565>, &S)> {
    Own { memory: vec![0; buffer_bytes::<Rgb565>(WIDTH as u16, HEIGHT as u16)], shape }
}

impl<S, F: FnMut(&mut Framebuffer<'_, Rgb565>, &S)> Engine<S> for Own<F> {
    fn draw(&mut self, shapes: &[S]) {
        let frame = Framebuffer::new(&mut self.memory, WIDTH as u16, HEIGHT as u16);
        let mut frame = frame.expect("the memory was made for this size");
        for shape in shapes {
            (self.shape)(&mut frame, shape);
        }
    }

    fn clear(&mut self) {
        self.memory.fill(0);
    }

    fn painted(&self) -> Mask {
        Mask::from_pixels(self.memory.chunks_exact(2).map(|bytes| bytes == INK.to_le_bytes()))
    }
}

fn ink() -> Rgb565 {
    RawU16::new(INK).into()
}
