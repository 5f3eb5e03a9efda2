//! The peers: zeno and ab_glyph_rasterizer, which make masks for glyphs, and raqote, which draws on pixels of 32 bits.

use ab_glyph_rasterizer::{point, Rasterizer};
use embedded_raster::FillRule;
use raqote::{DrawOptions, DrawTarget, LineCap, SolidSource, Source, StrokeStyle};
use zeno::{Fill, Mask, Scratch, Stroke, Vector};

use super::{engine::masked, outline::Outline, paths::Piece, shape::Soft, Levels, Ways};
use crate::{
    engine::{entry, Engine, Origin},
    frame::{HEIGHT, WIDTH},
};

fn zeno(frame: &mut [u8], shape: &Soft, scratch: &mut Scratch) {
    let mut mask = Mask::with_scratch(&shape.peers.zeno[..], scratch);
    mask.size(WIDTH as u32, HEIGHT as u32).offset(Vector::ZERO);
    if matches!(shape.outline, Outline::Line(..)) {
        mask.style(Stroke::new(1.0));
    } else {
        mask.style(match shape.rule {
            FillRule::NonZero => Fill::NonZero,
            FillRule::EvenOdd => Fill::EvenOdd,
        });
    }
    mask.render_into(frame, Some(WIDTH as usize));
}

/// In a box around the shape, as for a glyph, and from there to the frame.
fn accumulate(frame: &mut [u8], shape: &Soft, rasterizer: &mut Rasterizer) {
    let (mut low, mut high) = ([f32::MAX; 2], [f32::MIN; 2]);
    let mut meet = |p: [f32; 2]| {
        for i in 0..2 {
            (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
        }
    };
    for piece in &shape.peers.accumulated {
        match piece {
            Piece::Line(ends) => ends.iter().for_each(|&p| meet(p)),
            Piece::Cubic(points) => points.iter().for_each(|&p| meet(p)),
        }
    }
    let (x0, y0) = (low[0].floor().max(0.0), low[1].floor().max(0.0));
    let width = (high[0].ceil().min(WIDTH as f32) - x0).max(1.0) as usize;
    let height = (high[1].ceil().min(HEIGHT as f32) - y0).max(1.0) as usize;
    rasterizer.reset(width, height);
    let at = |[x, y]: [f32; 2]| point(x - x0, y - y0);
    for piece in &shape.peers.accumulated {
        match piece {
            Piece::Line(ends) => rasterizer.draw_line(at(ends[0]), at(ends[1])),
            Piece::Cubic(p) => rasterizer.draw_cubic(at(p[0]), at(p[1]), at(p[2]), at(p[3])),
        }
    }
    let start = y0 as usize * WIDTH as usize + x0 as usize;
    let (mut row, mut column) = (start, 0);
    rasterizer.for_each_pixel(|_, alpha| {
        let level = (alpha.min(1.0) * 255.0 + 0.5) as u8;
        if level != 0 {
            frame[row + column] = level;
        }
        column += 1;
        if column == width {
            (row, column) = (row + WIDTH as usize, 0);
        }
    });
}

struct Raqote(DrawTarget);

impl Engine<Soft, Levels> for Raqote {
    fn draw(&mut self, shapes: &[Soft]) {
        let white = Source::Solid(SolidSource { r: 255, g: 255, b: 255, a: 255 });
        let style = StrokeStyle { width: 1.0, cap: LineCap::Butt, ..StrokeStyle::default() };
        for shape in shapes {
            let path = &shape.peers.raqote;
            if matches!(shape.outline, Outline::Line(..)) {
                self.0.stroke(path, &white, &style, &DrawOptions::new());
            } else {
                self.0.fill(path, &white, &DrawOptions::new());
            }
        }
    }

    fn clear(&mut self) {
        self.0.clear(SolidSource { r: 0, g: 0, b: 0, a: 0 });
    }

    fn painted(&self) -> Levels {
        self.0.get_data().iter().map(|pixel| (pixel >> 24) as u8).collect()
    }
}

pub(super) fn entries() -> Ways {
    let (mut scratch, mut rasterizer) = (Scratch::new(), Rasterizer::new(1, 1));
    let mut sums =
        entry("ab_glyph", "ab_glyph_rasterizer", Origin::Peer, masked(move |f, s| accumulate(f, s, &mut rasterizer)));
    // It has no strokes.
    sums.can_hard = false;
    vec![
        entry("zeno", "zeno", Origin::Peer, masked(move |f, s| zeno(f, s, &mut scratch))),
        sums,
        entry("raqote", "raqote", Origin::Peer, Raqote(DrawTarget::new(WIDTH, HEIGHT))),
    ]
}
