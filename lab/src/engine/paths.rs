//! Ways to fill what cubic Bézier curves enclose, by the even-odd rule.

use embedded_raster::{raster::polygon, Canvas, ClippedSpan, EdgeSlot, FillRule::EvenOdd, Path};

use super::{
    curves::{halve, uniform},
    entry, ink, own, peers, plain,
    polygons::edge_table,
    Entry, Origin,
};
use crate::{
    frame::{Frame, WINDOW},
    shape::Blob,
};

/// Slots of the edge table: more than a row crosses lines of any shape here.
const TABLE: usize = 256;

pub(crate) fn entries() -> Vec<Entry<Blob>> {
    use Origin::{Crate, Peer, Textbook};
    let mut table = vec![EdgeSlot::EMPTY; TABLE];
    let mut exact = move |f: &mut Frame, b: &Blob| {
        let contours = Path::new(&b.segments).contours_in(WINDOW);
        polygon::fill(contours, EvenOdd, &mut table, WINDOW, |s: ClippedSpan| f.span(s))
            .expect("the table is large enough");
    };
    let mut scratch = vec![EdgeSlot::EMPTY; TABLE];
    vec![
        entry("uniform4", "4 lines a curve, f32 edge table", Textbook, plain(|f, b: &Blob| lines::<4>(f, b))),
        entry("uniform16", "16 lines a curve, f32 edge table", Textbook, plain(|f, b: &Blob| lines::<16>(f, b))),
        entry("halves", "de Casteljau, f32 edge table", Textbook, plain(|f, b: &Blob| halves(f, b))),
        entry("fill", "exact edge table: `polygon::fill`", Crate, plain(move |f, b: &Blob| exact(f, b))),
        entry(
            "canvas",
            "`Canvas::fill_path_fx`",
            Crate,
            own(move |f, b: &Blob| {
                f.fill_path_fx(Path::new(&b.segments), EvenOdd, &mut scratch, ink())
                    .expect("the table is large enough");
            }),
        ),
        entry("skia", "tiny-skia", Peer, peers::skia(|p, b: &Blob| peers::fill_even_odd(p, b.path.as_ref()))),
    ]
}

fn lines<const N: u16>(frame: &mut Frame, blob: &Blob) {
    let mut corners = Vec::new();
    blob.curves.iter().for_each(|curve| uniform(N, curve, |p| corners.push(p)));
    edge_table(frame, &corners);
}

fn halves(frame: &mut Frame, blob: &Blob) {
    let mut corners = Vec::new();
    blob.curves.iter().for_each(|curve| halve(curve.floats, &mut |p| corners.push(p), 0));
    edge_table(frame, &corners);
}
