//! Levels of gradients, word for word: a ratio, folded, and rounded once.

use super::{centre, wide, Units};

/// The nearest whole number to `n / d`, halves upwards.
fn nearest(n: i128, d: i128) -> i128 {
    (2 * n + d).div_euclid(2 * d)
}

/// A linear gradient at a pixel: 0 clamped, 1 repeated, 2 mirrored.
pub fn linear(ends: [Units; 2], outside: usize, x: i32, y: i32) -> u8 {
    let [a, b] = ends.map(wide);
    let (way, p) = ((b.0 - a.0, b.1 - a.1), (centre(x, 256) - a.0, centre(y, 256) - a.1));
    let (n, d) = (p.0 * way.0 + p.1 * way.1, way.0 * way.0 + way.1 * way.1);
    if d == 0 {
        return 0;
    }
    let n = match outside {
        0 => n.clamp(0, d),
        1 => n.rem_euclid(d),
        _ => n.rem_euclid(2 * d).min(2 * d - n.rem_euclid(2 * d)),
    };
    nearest(255 * n, d) as u8
}

/// A radial one. Its level n has `n - 1/2 <= z < n + 1/2` with `z = 255 |p - c| / r` folded: all in squares.
pub fn radial(centre_at: Units, radius: i32, outside: usize, x: i32, y: i32) -> u8 {
    let (c, r) = (wide(centre_at), i128::from(radius));
    let most = (1 << 22) - 1;
    let way = |p: i128, c: i128| (p - c).clamp(-most, most);
    let (dx, dy) = (way(centre(x, 256), c.0), way(centre(y, 256), c.1));
    // (2 z)^2 = X / r^2
    let square = 4 * 255 * 255 * (dx * dx + dy * dy);
    // Whether k / 2 is at most z.
    let reached = |k: i128| k <= 0 || k * k * r * r <= square;
    // The number of whole periods below z, by halving.
    let period = if outside == 1 { 255 } else { 510 };
    let (mut low, mut high) = (0_i128, 1 << 25);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if reached(2 * period * middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    match outside {
        0 => (0..255).rev().find(|n| reached(2 * n + 1)).map_or(0, |n| n + 1) as u8,
        1 => (0..255).rev().find(|n| reached(2 * (n + 255 * low) + 1)).map_or(0, |n| n + 1) as u8,
        _ if !reached(2 * (510 * low + 255)) => {
            (0..255).rev().find(|n| reached(2 * (n + 510 * low) + 1)).map_or(0, |n| n + 1) as u8
        }
        // 510 - z >= n - 1/2, where z is at most 510 - n + 1/2: not beyond it.
        _ => {
            let at_most = |k: i128| k >= 0 && k * k * r * r >= square;
            (0..=255_i128).rev().find(|n| at_most(2 * (510 * (low + 1) - n) + 1)).expect("one of them") as u8
        }
    }
}
