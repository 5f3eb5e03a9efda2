//! This crate and tiny-skia, which the lab has in any case.

use embedded_graphics::{pixelcolor::Gray8, prelude::GrayColor};
use embedded_raster::{
    paint::Cover,
    raster::coverage::{self, CoverageSlot},
    Antialias, Canvas, Framebuffer,
};
use tiny_skia::{FillRule, Mask, Paint, Pixmap, Stroke, Transform};

use super::{outline::Outline, shape::Soft, Levels, Ways};
use crate::{
    engine::{entry, Engine, Origin},
    frame::{HEIGHT, WIDTH},
};

pub(super) const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// A way to draw on a mask of bytes.
pub(super) struct Masked<F> {
    frame: Vec<u8>,
    draw: F,
}

pub(super) fn masked(draw: impl FnMut(&mut [u8], &Soft)) -> Masked<impl FnMut(&mut [u8], &Soft)> {
    Masked { frame: vec![0; PIXELS], draw }
}

impl<F: FnMut(&mut [u8], &Soft)> Engine<Soft, Levels> for Masked<F> {
    fn draw(&mut self, shapes: &[Soft]) {
        for shape in shapes {
            (self.draw)(&mut self.frame, shape);
        }
    }

    fn clear(&mut self) {
        self.frame.fill(0);
    }

    fn painted(&self) -> Levels {
        self.frame.clone()
    }
}

/// White on black at 8 bits: a pixel is its level.
fn own(frame: &mut [u8], shape: &Soft, table: &mut [CoverageSlot], cells: &mut [i32]) {
    let mut frame = Framebuffer::<Gray8>::new(frame, WIDTH as u16, HEIGHT as u16).expect("made for this size");
    let white = Cover(Gray8::WHITE);
    match &shape.outline {
        Outline::Polygon(_) => match &shape.contours[..] {
            [contour] if contour.len() == 3 => {
                frame.fill_triangle_aa([contour[0], contour[1], contour[2]], cells, white);
            }
            contours => frame.fill_contours_aa(contours, shape.rule, table, cells, white).expect("slots enough"),
        },
        Outline::Circle(..) => {
            frame.fill_ellipse_aa(shape.circle().expect("it is one"), white);
        }
        Outline::Curves(_) => frame.fill_path_aa(shape.path(), shape.rule, table, cells, white).expect("slots enough"),
        Outline::Line(..) => {
            let [a, b] = shape.ends().expect("it is one");
            frame.draw_line_aa(a, b, white);
        }
    }
}

/// The same, with true areas where sides cross. Circles and lines have no such pixels.
fn own_true(frame: &mut [u8], shape: &Soft, table: &mut [CoverageSlot], cells: &mut [i32]) {
    let size = (WIDTH as u16, HEIGHT as u16);
    let draw = |frame: &mut [u8], table: &mut [CoverageSlot], cells: &mut [i32]| {
        let mut frame = Framebuffer::<Gray8>::new(frame, size.0, size.1).expect("made for this size");
        frame.paint(Cover(Gray8::WHITE), |window, brush| match shape.outline {
            Outline::Polygon(_) => {
                coverage::fill_true(shape.contours.iter(), shape.rule, table, cells, window, brush).map(|()| true)
            }
            Outline::Curves(_) => {
                coverage::path_true(shape.path(), shape.rule, table, cells, window, brush).map(|()| true)
            }
            Outline::Circle(..) | Outline::Line(..) => Ok(false),
        })
    };
    if !draw(frame, table, cells).expect("slots enough") {
        own(frame, shape, table, cells);
    }
}

/// tiny-skia: paths on masks, lines on a pixmap.
struct Skia {
    mask: Mask,
    pixmap: Pixmap,
}

impl Engine<Soft, Levels> for Skia {
    fn draw(&mut self, shapes: &[Soft]) {
        let mut paint = Paint::default();
        paint.set_color_rgba8(255, 255, 255, 255);
        for shape in shapes {
            let Some(path) = &shape.skia else { continue };
            let rule = match shape.rule {
                embedded_raster::FillRule::NonZero => FillRule::Winding,
                embedded_raster::FillRule::EvenOdd => FillRule::EvenOdd,
            };
            if matches!(shape.outline, Outline::Line(..)) {
                let stroke = Stroke { width: 1.0, ..Stroke::default() };
                self.pixmap.stroke_path(path, &paint, &stroke, Transform::identity(), None);
            } else {
                self.mask.fill_path(path, rule, true, Transform::identity());
            }
        }
    }

    fn clear(&mut self) {
        self.mask.clear();
        self.pixmap.fill(tiny_skia::Color::TRANSPARENT);
    }

    fn painted(&self) -> Levels {
        self.mask.data().iter().zip(self.pixmap.pixels()).map(|(&a, b)| a.max(b.alpha())).collect()
    }
}

pub(super) fn entries() -> Ways {
    let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; 512], vec![0; coverage::cells(WIDTH as u16)]);
    let mut more = (table.clone(), cells.clone());
    let (width, height) = (WIDTH as u32, HEIGHT as u32);
    let skia = Skia {
        mask: Mask::new(width, height).expect("the size is not zero"),
        pixmap: Pixmap::new(width, height).expect("the size is not zero"),
    };
    vec![
        entry("own", "this crate", Origin::Crate, masked(move |f, s| own(f, s, &mut table, &mut cells))),
        entry(
            "true",
            "this crate, true area",
            Origin::Crate,
            masked(move |f, s| own_true(f, s, &mut more.0, &mut more.1)),
        ),
        entry("skia", "tiny-skia", Origin::Peer, skia),
    ]
}
