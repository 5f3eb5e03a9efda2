//! The list of what makes paths: texts, arcs, maps, and how they are filled and measured without a surface.

use embedded_raster::{
    geom::{Arc, Contours, Curves, RoundCorners},
    raster::{
        arc, chord, gauge,
        polygon::{self, drop_out},
        stroke,
    },
    Affine, ClippedSpan, Layout, PackedPath, Path, PathSegment, PointFx, Svg,
};
use fixed::types::I16F16;

use crate::{
    answer::{sum, Answer},
    calls,
};

calls! {
    /// Makes the call of a number below that of [`NAMES`], with a text that is a path or is none.
    NAMES, call[L: Layout](on: &str, a)
    {
        let (window, rule, [p, q, ..]) = (a.window, a.rule(), a.places);
        let [xx, xy, dx, yx, yy, dy] = a.numbers.map(I16F16::from_bits);
        let map = Affine { xx, xy, dx, yx, yy, dy };
        let rotation = embedded_raster::Angle::from_bits(dy.to_bits().cast_unsigned());
        let piece = Arc { radii: [a.size, a.phase], rotation, is_large: a.flag, is_clockwise: xx.is_negative() };
        let segments = a.segments;
    }
    [Affine]
    default => Affine::default().apply(p);
    scale => Affine::scale(xx, yy).apply(p);
    translate => Affine::translate(dx, dy).apply(p);
    rotate => Affine::rotate(rotation).apply(p);
    then => map.then(map).apply(p);
    apply => map.apply(p);
    segment => segments.first().map(|&segment| digest(map.segment(segment)));
    path => digests(map.path(segments));
    [Mapped]
    next => map.path(segments).next().map(digest);
    [Arc]
    circle => digests(Arc::circle(a.size).between(p, q));
    between => digests(piece.between(p, q));
    [Curves]
    ellipse => digests(Curves::ellipse(p, [a.size, a.phase], rotation));
    arc => digests(Curves::arc(p, [a.size, a.phase], rotation, rotation.plus(dx.to_bits())));
    mapped => digests(piece.between(p, q).mapped(map));
    step => piece.between(p, q).step().map(digest);
    next => piece.between(p, q).next().map(digest);
    [RoundCorners]
    new => digests(RoundCorners::new(a.contour, a.flag, a.size));
    next => RoundCorners::new(a.contour, a.flag, a.size).next().map(digest);
    [arc]
    path => digests(arc::path(p, [a.size, a.phase], a.sector));
    stroke => {
        let (mut sum, stroke) = (0_usize, a.stroke.dashed(a.dashes, a.phase));
        arc::stroke(p, [a.size, a.phase], a.sector, &stroke, a.table, window, add(&mut sum)).map(|()| sum)
    };
    [chord]
    fill => {
        let mut sum = 0_usize;
        chord::fill(a.ellipses[0], a.sector, window, add(&mut sum));
        sum
    };
    [gauge]
    fill => {
        let mut sum = 0_usize;
        gauge::fill(a.ellipses[0], a.ellipses[1], a.sector, window, add(&mut sum));
        sum
    };
    [Path]
    svg => Path::svg(on).map(Svg::len);
    into_iter => digests(Path::new(segments));
    packed => Path::packed(a.bytes).map(PackedPath::len);
    [PackedPath]
    bytes => packed(a.bytes).map(|path| path.bytes().len());
    iter => packed(a.bytes).map(|path| digests(path.iter()));
    mapped => packed(a.bytes).map(|path| digests(path.mapped(map)));
    len => packed(a.bytes).map(PackedPath::len);
    is_empty => packed(a.bytes).map(PackedPath::is_empty);
    into_iter => packed(a.bytes).map(digests);
    [PackedSegments]
    step => packed(a.bytes).map(|path| path.mapped(map).step().map(digest));
    next => packed(a.bytes).map(|path| path.mapped(map).next().map(digest));
    [Svg]
    iter => svg(on).map(|path| digests(path.iter()));
    mapped => svg(on).map(|path| digests(path.mapped(map)));
    len => svg(on).map(Svg::len);
    is_empty => svg(on).map(Svg::is_empty);
    to_array => svg(on).map(|path| path.to_array::<5>().map(digests));
    into_iter => svg(on).map(digests);
    [SvgSegments]
    step => svg(on).map(|path| path.mapped(map).step().map(digest));
    next => svg(on).map(|path| path.mapped(map).next().map(digest));
    [Contours]
    new => svg(on).map(|path| sum(Contours::new(path).take(3).map(|contour| sum(contour.take(50)))));
    within => sum(Contours::within(map.path(segments), window).map(sum));
    finely_within => sum(Contours::finely_within(map.path(segments), window).map(sum));
    [polygon]
    edge_slots => {
        let (first, second) = a.contour.split_at_checked(a.length(5) % 8).unwrap_or((a.contour, &[]));
        let slots = polygon::edge_slots([first, second], window);
        (slots.whole, slots.least)
    };
    [drop_out]
    fill => {
        let (mut sum, contour) = (0_usize, a.contour.get(..a.contour.len().min(8)).unwrap_or_default());
        let drop_out = drop_out::DropOut { smart: a.flag, stubs: xx.is_negative() };
        let filled = drop_out::fill([contour], rule, drop_out, a.table, window, add(&mut sum));
        filled.map(|()| sum)
    };
    edge_slots => {
        let slots = drop_out::edge_slots([a.contour], window);
        (slots.whole, slots.least)
    };
    [stroke]
    edge_slots => {
        let slots = stroke::edge_slots(Path::new(segments), &a.stroke.dashed(a.dashes, a.phase), window);
        (slots.whole, slots.least)
    };
}

/// A path of some bytes, as far as they make sense.
fn packed(bytes: &[u8]) -> Option<PackedPath<'_>> {
    let end = Path::packed(bytes).map_or_else(|error| error.position, |_| bytes.len());
    Path::packed(bytes.get(..end)?).ok()
}

fn svg(text: &str) -> Option<Svg<'_>> {
    Path::svg(text).ok()
}

/// A number that depends on a segment.
fn digest(segment: PathSegment) -> usize {
    let none = PointFx::default();
    match segment {
        PathSegment::MoveTo(a) => [a, none, none].answer(),
        PathSegment::LineTo(a) => [none, a, none].answer(),
        PathSegment::QuadraticTo(c, a) => [c, a, none].answer(),
        PathSegment::CubicTo(c, d, a) => [c, d, a].answer(),
        PathSegment::Close => 1,
    }
}

fn digests(segments: impl IntoIterator<Item = PathSegment>) -> usize {
    sum(segments.into_iter().map(digest))
}

/// A sink that computes a sum of all spans.
fn add(sum: &mut usize) -> impl FnMut(ClippedSpan) + '_ {
    move |span| *sum = (*sum, span).answer()
}
