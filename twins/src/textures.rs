//! Pictures at places between their pixels, word for word.

/// Which of `n` columns stands in the place of column i: 0 the nearest, 1 repeated, 2 mirrored.
pub fn column(i: i64, n: i64, outside: usize) -> i64 {
    match outside {
        0 => i.clamp(0, n - 1),
        1 => i.rem_euclid(n),
        // 0, 1, .. n - 1, n - 1, .. 1, 0, and again.
        _ => i.rem_euclid(2 * n).min(2 * n - 1 - i.rem_euclid(2 * n)),
    }
}

/// The columns of the two centres around a place in 2^-16, and how much of each there is in 2^-16.
pub fn columns(u: i64) -> [(i64, i128); 2] {
    // Centres are at 2^16 i + 2^15.
    let before = (u - (1 << 15)).div_euclid(1 << 16);
    let part = i128::from(u - (before * (1 << 16) + (1 << 15)));
    [(before, (1 << 16) - part), (before + 1, part)]
}

/// The nearest whole number to the mean of the levels around a place, halves upwards.
pub fn bilinear(u: i64, v: i64, level: impl Fn(i64, i64) -> i128) -> i128 {
    let mut sum = 0;
    for (j, down) in columns(v) {
        for (i, right) in columns(u) {
            sum += level(i, j) * right * down;
        }
    }
    (2 * sum + (1_i128 << 32)).div_euclid(1 << 33)
}
