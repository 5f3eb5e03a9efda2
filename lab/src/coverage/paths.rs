//! [`Paths`]: an outline as each of the peers wants it, made before anything is measured.

use embedded_raster::FillRule;
use raqote::{PathBuilder, Winding};
use zeno::Command;

use super::outline::{Builder, Outline};

/// An outline as each of them wants it.
pub(crate) struct Paths {
    pub(super) zeno: Vec<Command>,
    pub(super) raqote: raqote::Path,
    pub(super) accumulated: Vec<Piece>,
}

/// A side or a curve.
pub(super) enum Piece {
    Line([[f32; 2]; 2]),
    Cubic([[f32; 2]; 4]),
}

/// Pieces, each from where the one before ended.
#[derive(Default)]
struct Pieces {
    pieces: Vec<Piece>,
    start: [f32; 2],
    at: [f32; 2],
}

impl Builder for Pieces {
    fn start(&mut self, at: [f32; 2]) {
        (self.start, self.at) = (at, at);
    }

    fn line(&mut self, to: [f32; 2]) {
        self.pieces.push(Piece::Line([self.at, to]));
        self.at = to;
    }

    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]) {
        self.pieces.push(Piece::Cubic([self.at, c, d, b]));
        self.at = b;
    }

    fn close(&mut self) {
        self.line(self.start);
    }
}

impl Builder for Vec<Command> {
    fn start(&mut self, at: [f32; 2]) {
        self.push(Command::MoveTo(at.into()));
    }

    fn line(&mut self, to: [f32; 2]) {
        self.push(Command::LineTo(to.into()));
    }

    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]) {
        self.push(Command::CurveTo(c.into(), d.into(), b.into()));
    }

    fn close(&mut self) {
        self.push(Command::Close);
    }
}

impl Builder for PathBuilder {
    fn start(&mut self, [x, y]: [f32; 2]) {
        self.move_to(x, y);
    }

    fn line(&mut self, [x, y]: [f32; 2]) {
        self.line_to(x, y);
    }

    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]) {
        self.cubic_to(c[0], c[1], d[0], d[1], b[0], b[1]);
    }

    fn close(&mut self) {
        Self::close(self);
    }
}

impl Paths {
    pub(crate) fn new(outline: &Outline, rule: FillRule) -> Self {
        let (mut zeno, mut builder, mut pieces) = (Vec::new(), PathBuilder::new(), Pieces::default());
        outline.tell(&mut zeno);
        outline.tell(&mut builder);
        outline.tell(&mut pieces);
        let mut raqote = builder.finish();
        raqote.winding = match rule {
            FillRule::NonZero => Winding::NonZero,
            FillRule::EvenOdd => Winding::EvenOdd,
        };
        Self { zeno, raqote, accumulated: pieces.pieces }
    }
}
