//! Path data of SVG, the text of a `d` attribute, as the segments of a path.

use embedded_raster::{
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx,
};
use fixed::types::I24F8;
use svgtypes::{SimplePathSegment as Simple, SimplifyingPathParser};

/// The segments of a path that is written as path data of SVG: all commands, `M L H V C S Q T A Z` and their relative ones. Arcs
/// become cubic curves. Numbers are pixels; they are rounded to the nearest 1/256, and stop at the ends of the range.
///
/// # Errors
/// What is wrong, in a line, with the place of the character, the first one being 1.
/// ```
/// use embedded_raster::{PathSegment::*, PointFx};
/// use embedded_raster_simulator::path_data;
/// let p = PointFx::px;
/// assert_eq!(path_data("M1,2h3v4z"), Ok(vec![MoveTo(p(1, 2)), LineTo(p(4, 2)), LineTo(p(4, 6)), Close]));
/// assert_eq!(path_data("M1,2 L3"), Err("the path ends too early, at character 8".into()));
/// ```
pub fn path_data(text: &str) -> Result<Vec<PathSegment>, String> {
    let number = |n: f64| I24F8::saturating_from_num(n);
    let place = |x: f64, y: f64| PointFx::new(number(x), number(y));
    let mut segments = Vec::new();
    for segment in SimplifyingPathParser::from(text) {
        segments.push(match segment.map_err(|error| told(&error, text))? {
            Simple::MoveTo { x, y } => MoveTo(place(x, y)),
            Simple::LineTo { x, y } => LineTo(place(x, y)),
            Simple::CurveTo { x1, y1, x2, y2, x, y } => CubicTo(place(x1, y1), place(x2, y2), place(x, y)),
            Simple::Quadratic { x1, y1, x, y } => QuadraticTo(place(x1, y1), place(x, y)),
            Simple::ClosePath => Close,
        });
    }
    Ok(segments)
}

fn told(error: &svgtypes::Error, text: &str) -> String {
    match error {
        svgtypes::Error::UnexpectedEndOfStream => {
            format!("the path ends too early, at character {}", text.chars().count() + 1)
        }
        svgtypes::Error::UnexpectedData(at) => format!("the path goes on with something else at character {at}"),
        svgtypes::Error::InvalidNumber(at) => format!("a number is wrong in the path at character {at}"),
        other => format!("the path is wrong: {other}"),
    }
}
