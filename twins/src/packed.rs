//! Packed paths by their table, bit by bit.

use embedded_raster::{
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx,
};

type Fine = [i64; 2];

fn in_range(n: i64) -> i64 {
    n.clamp(-(1 << 39), (1 << 39) - 1)
}

/// A place in units of 1/65,536, rounded to 1/256 pixel.
fn place(at: Fine) -> PointFx {
    let [x, y] = at.map(|n| i32::try_from(((n + 128) >> 8).clamp(i32::MIN.into(), i32::MAX.into())).expect("clamped"));
    PointFx::from_bits(x, y)
}

/// The segments of a packed path, or the position of the first byte that makes no sense.
///
/// # Errors
/// That position.
pub fn read(bytes: &[u8]) -> Result<Vec<PathSegment>, usize> {
    let bit = |i: usize| bytes[i / 8] >> (7 - i % 8) & 1 != 0;
    let fraction = u32::from(*bytes.first().filter(|&&fraction| fraction <= 8).ok_or(0_usize)?);
    let (mut position, mut all) = (1, vec![]);
    let (mut at, mut start, mut control) = ([0; 2], [0; 2], None::<Fine>);
    while position < bytes.len() {
        let begin = position;
        let (command, width) = (bytes[begin] >> 5, usize::from(bytes[begin] & 31) + 1);
        let count = [0, 2, 2, 1, 1, 4, 6, 4][usize::from(command)];
        if command == 0 && width != 1 || begin + 1 + (count * width).div_ceil(8) > bytes.len() {
            return Err(begin);
        }
        if all.is_empty() && command != 1 {
            return Err(begin);
        }
        let number = |i: usize| {
            let from = 8 * (begin + 1) + i * width;
            let sign = if bit(from) { -1 } else { 0 };
            let n = (from..from + width).fold(sign, |n: i64, i| n * 2 + i64::from(bit(i)));
            n << (16 - fraction)
        };
        let add = |at: Fine, i: usize| [in_range(at[0] + number(i)), in_range(at[1] + number(i + 1))];
        let (mut next, mirrored) = (None, control.map_or(at, |c| [0, 1].map(|k| in_range(2 * at[k] - c[k]))));
        let (to, segment) = match command {
            0 => (start, Close),
            1 => {
                start = add(at, 0);
                (start, MoveTo(place(start)))
            }
            2 => (add(at, 0), LineTo(place(add(at, 0)))),
            3 => {
                let to = [in_range(at[0] + number(0)), at[1]];
                (to, LineTo(place(to)))
            }
            4 => {
                let to = [at[0], in_range(at[1] + number(0))];
                (to, LineTo(place(to)))
            }
            5 => {
                let c = add(at, 0);
                let to = add(c, 2);
                (to, QuadraticTo(place(c), place(to)))
            }
            _ => {
                let (c, i) = if command == 6 { (add(at, 0), 2) } else { (mirrored, 0) };
                let d = add(c, i);
                let to = add(d, i + 2);
                next = Some(d);
                (to, CubicTo(place(c), place(d), place(to)))
            }
        };
        all.push(segment);
        (at, control) = (to, next);
        position = begin + 1 + (count * width).div_ceil(8);
    }
    Ok(all)
}
