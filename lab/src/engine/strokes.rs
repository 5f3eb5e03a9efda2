//! Ways to draw lines with a width.

use embedded_graphics::{
    prelude::*,
    primitives::{Line, PrimitiveStyle},
};
use embedded_raster::{raster::stroke, Canvas, Cap, ClippedSpan, EdgeSlot, Join, Stroke};
use tiny_skia::{LineCap, LineJoin};

use super::{entry, ink, own, peers, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH, WINDOW},
    shape::Thick,
};

/// Slots of the edge table: more than a row crosses pieces of any shape here.
const TABLE: usize = 512;

pub(crate) fn entries() -> Vec<Entry<Thick>> {
    use Origin::{Crate, Peer, Textbook};
    let mut table = vec![EdgeSlot::EMPTY; TABLE];
    let mut exact = move |f: &mut Frame, t: &Thick| {
        stroke::fill_polyline(&t.vertices, false, &style(t), &mut table, WINDOW, |s: ClippedSpan| f.span(s))
            .expect("the table is large enough");
    };
    let mut scratch = vec![EdgeSlot::EMPTY; TABLE];
    let mut entries = vec![
        entry("distance", "distance in f32, per pixel", Textbook, plain(|f, t: &Thick| by_distance(f, t))),
        entry("pieces", "spans: `stroke::fill_polyline`", Crate, plain(move |f, t: &Thick| exact(f, t))),
        entry(
            "canvas",
            "`Canvas::stroke_polyline_fx`",
            Crate,
            own(move |f, t: &Thick| {
                f.stroke_polyline_fx(&t.vertices, false, &style(t), &mut scratch, ink())
                    .expect("the table is large enough");
            }),
        ),
        entry(
            "eg",
            "embedded-graphics",
            Peer,
            peers::graphics(|f, t: &Thick| {
                let style = PrimitiveStyle::with_stroke(ink(), t.width.into());
                for ends in t.pixels.windows(2) {
                    let Ok(()) = Line::new(ends[0], ends[1]).into_styled(style).draw(f);
                }
            }),
        ),
        entry("skia", "tiny-skia", Peer, peers::skia(|p, t: &Thick| peers::stroke(p, t.path.as_ref(), &skia_style(t)))),
    ];
    for entry in &mut entries {
        // It has no round ends.
        entry.can_hard = entry.key != "eg";
    }
    entries
}

fn style(thick: &Thick) -> Stroke {
    let stroke = Stroke::px(thick.width);
    if thick.round {
        stroke.with_cap(Cap::Round).with_join(Join::Round)
    } else {
        stroke
    }
}

fn skia_style(thick: &Thick) -> tiny_skia::Stroke {
    let (line_cap, line_join) =
        if thick.round { (LineCap::Round, LineJoin::Round) } else { (LineCap::Butt, LineJoin::Miter) };
    tiny_skia::Stroke { width: thick.width.into(), line_cap, line_join, ..tiny_skia::Stroke::default() }
}

/// The pixels of the box around each line whose centres are not further from it than half the width.
fn by_distance(frame: &mut Frame, thick: &Thick) {
    let half = f32::from(thick.width) / 2.0;
    let margin = i32::from(thick.width) / 2 + 1;
    for ends in thick.pixels.windows(2) {
        let [a, b] = [ends[0], ends[1]];
        let (dx, dy) = ((b.x - a.x) as f32, (b.y - a.y) as f32);
        let square = dx * dx + dy * dy;
        for y in (a.y.min(b.y) - margin).max(0)..(a.y.max(b.y) + margin + 1).min(HEIGHT) {
            for x in (a.x.min(b.x) - margin).max(0)..(a.x.max(b.x) + margin + 1).min(WIDTH) {
                let (px, py) = ((x - a.x) as f32, (y - a.y) as f32);
                let t = (px * dx + py * dy) / square;
                if !thick.round && !(0.0..=1.0).contains(&t) {
                    continue;
                }
                let t = t.clamp(0.0, 1.0);
                let (ox, oy) = (px - t * dx, py - t * dy);
                if ox * ox + oy * oy <= half * half {
                    frame.put(x, y);
                }
            }
        }
    }
}
