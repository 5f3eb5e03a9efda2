//! SVG path data as svgtypes reads it, another reader.

#![allow(clippy::cast_possible_truncation, reason = "clamped before")]

use embedded_raster::{
    Path,
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx, SvgError,
};
use svgtypes::{PathParser, PathSegment as Step};

/// A place in units of 1/65,536.
pub type Fine = [i64; 2];

/// A number in units of 1/65,536.
pub fn unit(n: f64) -> i64 {
    ((n * 65_536.0).round() as i64).clamp(-(1 << 39), (1 << 39) - 1)
}

/// A place in these units, rounded to 1/256 pixel.
pub fn place(at: Fine) -> PointFx {
    let [x, y] = at.map(|n| i32::try_from(((n + 128) >> 8).clamp(i32::MIN.into(), i32::MAX.into())).expect("clamped"));
    PointFx::from_bits(x, y)
}

/// What svgtypes reads, as places: relative ones added up, and control points mirrored. Of arcs there are both ends.
///
/// # Errors
/// Those of svgtypes.
pub fn read(text: &str) -> Result<Vec<Result<PathSegment, [Fine; 2]>>, svgtypes::Error> {
    let (mut at, mut start, mut control, mut last) = ([0, 0], [0, 0], [0, 0], ' ');
    let mut all = vec![];
    for step in PathParser::from(text) {
        let step = step?;
        let base = |abs: bool| if abs { [0, 0] } else { at };
        let end = |n: i64| n.clamp(-(1 << 39), (1 << 39) - 1);
        let add = |abs: bool, x: f64, y: f64| {
            let base = base(abs);
            [end(base[0] + unit(x)), end(base[1] + unit(y))]
        };
        let mirrored = |kind| if last == kind { [0, 1].map(|i| end(2 * at[i] - control[i])) } else { at };
        let (to, segment, kind) = match step {
            Step::MoveTo { abs, x, y } => {
                start = add(abs, x, y);
                (start, Some(MoveTo(place(start))), ' ')
            }
            Step::LineTo { abs, x, y } => {
                let to = add(abs, x, y);
                (to, Some(LineTo(place(to))), ' ')
            }
            Step::HorizontalLineTo { abs, x } => {
                let to = [add(abs, x, 0.0)[0], at[1]];
                (to, Some(LineTo(place(to))), ' ')
            }
            Step::VerticalLineTo { abs, y } => {
                let to = [at[0], add(abs, 0.0, y)[1]];
                (to, Some(LineTo(place(to))), ' ')
            }
            Step::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                let (c, d, to) = (add(abs, x1, y1), add(abs, x2, y2), add(abs, x, y));
                control = d;
                (to, Some(CubicTo(place(c), place(d), place(to))), 'C')
            }
            Step::SmoothCurveTo { abs, x2, y2, x, y } => {
                let (c, d, to) = (mirrored('C'), add(abs, x2, y2), add(abs, x, y));
                control = d;
                (to, Some(CubicTo(place(c), place(d), place(to))), 'C')
            }
            Step::Quadratic { abs, x1, y1, x, y } => {
                let (c, to) = (add(abs, x1, y1), add(abs, x, y));
                control = c;
                (to, Some(QuadraticTo(place(c), place(to))), 'Q')
            }
            Step::SmoothQuadratic { abs, x, y } => {
                let (c, to) = (mirrored('Q'), add(abs, x, y));
                control = c;
                (to, Some(QuadraticTo(place(c), place(to))), 'Q')
            }
            Step::EllipticalArc { abs, x, y, .. } => (add(abs, x, y), None, ' '),
            Step::ClosePath { .. } => (start, Some(Close), ' '),
        };
        all.push(segment.ok_or([at, to]));
        (at, last) = (to, kind);
    }
    Ok(all)
}

/// How far apart two places may be, in units of 1/256: a float may be rounded to another 1/65,536 where a decimal number has many
/// digits, and a place is a sum of up to hundreds of numbers.
const SLACK: u32 = 2;

fn is_near(a: PointFx, b: PointFx) -> bool {
    a.x.to_bits().abs_diff(b.x.to_bits()) <= SLACK && a.y.to_bits().abs_diff(b.y.to_bits()) <= SLACK
}

fn agree(a: PathSegment, b: PathSegment) -> bool {
    match (a, b) {
        (MoveTo(a), MoveTo(b)) | (LineTo(a), LineTo(b)) => is_near(a, b),
        (QuadraticTo(c, a), QuadraticTo(d, b)) => is_near(c, d) && is_near(a, b),
        (CubicTo(c, d, a), CubicTo(e, f, b)) => is_near(c, e) && is_near(d, f) && is_near(a, b),
        (Close, Close) => true,
        _ => false,
    }
}

/// Whether it has an exponent of three digits: svgtypes refuses numbers that are infinite as floats.
fn is_beyond_floats(text: &str) -> bool {
    text.split(['e', 'E']).skip(1).any(|rest| {
        let digits = rest.strip_prefix(['+', '-']).unwrap_or(rest);
        digits.len() >= 3 && digits.bytes().take(3).all(|digit| digit.is_ascii_digit())
    })
}

/// Compares what both readers make of any text: whether it makes sense, and its segments. Whether it made sense.
pub fn check(text: &str) -> bool {
    let path = match Path::svg(text) {
        Ok(path) => path,
        Err(SvgError { position, .. }) => {
            assert!(text.is_char_boundary(position), "{position} of {text:?}");
            // Only svgtypes takes a comma behind the last argument of a command.
            let has_comma = text[..position].trim_end().ends_with(',');
            assert!(has_comma || read(text).is_err(), "{position} of {text:?}");
            return false;
        }
    };
    let Ok(wanted) = read(text) else {
        assert!(is_beyond_floats(text) || text.contains('\x0c'), "only svgtypes refuses {text:?}");
        return false;
    };
    let got: Vec<PathSegment> = path.iter().collect();
    let mut stepped = path.iter();
    assert!(got.iter().all(|&segment| stepped.step() == Some(segment)) && stepped.step().is_none(), "{text:?}");
    assert_eq!((path.len(), path.is_empty()), (got.len(), got.is_empty()), "{text:?}");
    let mut rest = got.iter().copied();
    for (i, step) in wanted.iter().enumerate() {
        match *step {
            Ok(step) => {
                let next = rest.next();
                assert!(next.is_some_and(|next| agree(next, step)), "{next:?}, {step:?}: command {i} of {text:?}");
            }
            Err([from, to]) if from == to => {}
            Err([_, to]) => {
                let end = place(to);
                let ends = |segment| matches!(segment, CubicTo(_, _, at) | LineTo(at) if is_near(at, end));
                assert!(rest.by_ref().take(64).any(ends), "command {i} of {text:?}");
            }
        }
    }
    true
}
