//! [`fitted`]: path data in numbers that 16.16 maps exactly enough.

use std::{borrow::Cow, fmt::Write};

use svgtypes::{PathParser, PathSegment, Transform};

/// The largest number of a map that is made here: the places of a path are as far from each other as they are on the screen, by
/// this. Then places and the numbers of the map, with 16 bits of fraction both, are equally good.
const LARGEST: f64 = 64.0;
/// How far from the corner of the screen a path may begin.
const FAR: f64 = 16_384.0;

/// The same path with a map of 16.16. Where that would round the map, the path itself is scaled and moved: one in degrees or in metres,
/// or with a view box that is much larger than the screen, would be off by pixels else.
pub(super) fn fitted(data: &str, map: Transform) -> (Cow<'_, str>, Transform) {
    let Transform { a, b, c, d, e, f } = map;
    let is_exact = |n: f64| (n * 65_536.0).fract() == 0.0 && n.abs() < 32_768.0;
    let largest = [a, b, c, d].into_iter().fold(0.0, |most: f64, n| most.max(n.abs()));
    let is_near = |(x, y): (f64, f64)| x.abs() < FAR && y.abs() < FAR;
    if [a, b, c, d].into_iter().all(is_exact) && is_near((e, f)) || !largest.is_normal() {
        return (Cow::Borrowed(data), map);
    }
    let scale = (largest / LARGEST).log2().ceil().exp2();
    let start = PathParser::from(data).next().and_then(Result::ok).map_or((0.0, 0.0), |first| match first {
        PathSegment::MoveTo { x, y, .. } => (x, y),
        _ => (0.0, 0.0),
    });
    let mapped = |(x, y): (f64, f64)| (a * x + c * y + e, b * x + d * y + f);
    // A path that begins far from the screen is moved to the place that the corner of the screen comes from.
    let area = a * d - b * c;
    let corner = ((c * f - d * e) / area, (b * e - a * f) / area);
    let from = if is_near(mapped(start)) || !area.is_normal() { start } else { corner };
    let [a, b, c, d] = [a, b, c, d].map(|n| n / scale);
    let (e, f) = mapped(from);
    (Cow::Owned(scaled(data, scale, from)), Transform::new(a, b, c, d, e, f))
}

/// Path data so many times as large, after a place was moved to (0, 0).
pub(super) fn scaled(data: &str, scale: f64, from: (f64, f64)) -> String {
    let mut text = String::new();
    for (number, segment) in PathParser::from(data).map_while(Result::ok).enumerate() {
        // The first move is absolute, however it is written.
        let is_moved = number == 0;
        let place = |abs: bool, x: f64, y: f64| {
            let (left, top) = if abs || is_moved { from } else { (0.0, 0.0) };
            format!("{:.9} {:.9} ", (x - left) * scale, (y - top) * scale)
        };
        let letter = |abs: bool, letter: char| if abs { letter.to_ascii_uppercase() } else { letter };
        _ = match segment {
            PathSegment::MoveTo { abs, x, y } => write!(text, "{}{}", letter(abs, 'm'), place(abs, x, y)),
            PathSegment::LineTo { abs, x, y } => write!(text, "{}{}", letter(abs, 'l'), place(abs, x, y)),
            PathSegment::HorizontalLineTo { abs, x } => {
                write!(text, "{}{:.9}", letter(abs, 'h'), (x - if abs { from.0 } else { 0.0 }) * scale)
            }
            PathSegment::VerticalLineTo { abs, y } => {
                write!(text, "{}{:.9}", letter(abs, 'v'), (y - if abs { from.1 } else { 0.0 }) * scale)
            }
            PathSegment::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                let [first, second, end] = [(x1, y1), (x2, y2), (x, y)].map(|(x, y)| place(abs, x, y));
                write!(text, "{}{first}{second}{end}", letter(abs, 'c'))
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                write!(text, "{}{}{}", letter(abs, 's'), place(abs, x2, y2), place(abs, x, y))
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                write!(text, "{}{}{}", letter(abs, 'q'), place(abs, x1, y1), place(abs, x, y))
            }
            PathSegment::SmoothQuadratic { abs, x, y } => write!(text, "{}{}", letter(abs, 't'), place(abs, x, y)),
            PathSegment::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                let [rx, ry] = [rx, ry].map(|radius| radius * scale);
                let flags = format!("{} {}", u8::from(large_arc), u8::from(sweep));
                let letter = letter(abs, 'a');
                write!(text, "{letter}{rx:.9} {ry:.9} {x_axis_rotation:.9} {flags} {}", place(abs, x, y))
            }
            PathSegment::ClosePath { .. } => write!(text, "z"),
        };
    }
    text
}
