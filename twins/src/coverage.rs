//! Coverage in wide integers: the exact area of a polygon in a pixel, without any grid.
//!
//! Each side adds what lies right of it in the pixel, weighted by its winding. That is an integral along the side, a fraction of
//! whole numbers, and is cut to `2^-40` of a square unit: `2^-56` of a pixel.

use embedded_raster::{ClippedSpan, FillRule, Rect, Sink};

use crate::Units;

/// The area of a pixel.
pub const PIXEL: i128 = 1 << 56;

/// What the sides of closed contours cover of a pixel, each weighted by its winding, in `2^-56` pixels. It is off by less than one
/// for each side.
pub fn winding_area(contours: &[Vec<Units>], (x, y): (i32, i32)) -> i128 {
    sides(contours).map(|(a, b)| side_area(a, b, (x, y))).sum()
}

/// What is covered of a pixel by a fill rule: the rule applied to the sum as a whole.
pub fn area(contours: &[Vec<Units>], rule: FillRule, pixel: (i32, i32)) -> i128 {
    let size = winding_area(contours, pixel).abs();
    match rule {
        FillRule::NonZero => size.min(PIXEL),
        FillRule::EvenOdd => {
            let odd = size % (2 * PIXEL);
            odd.min(2 * PIXEL - odd)
        }
    }
}

/// The true area of a shape in a pixel, also where its sides cross there, in `2^-56` pixels: the pixel is cut into strips at each end,
/// crossing and border, and in a strip the parts are trapezoids. Places are cut to `2^-40` of a unit, so a strip may be off by 2 of
/// these. For places below 2^23 units.
pub fn true_area(contours: &[Vec<Units>], rule: FillRule, (x, y): (i32, i32)) -> i128 {
    let (left, top) = (i128::from(x) << 48, i128::from(y) << 48);
    let sides: Vec<_> = sides(contours).filter_map(|(a, b)| Strip::new(a, b, (top, top + (1 << 48)))).collect();
    let mut cuts = vec![top, top + (1 << 48)];
    for (i, side) in sides.iter().enumerate() {
        cuts.extend([side.a.1 << 40, (side.a.1 + side.by.1) << 40]);
        cuts.extend([left, left + (1 << 48)].into_iter().filter_map(|x| side.row_of(x)));
        cuts.extend(sides[..i].iter().filter_map(|other| side.crossing(other)));
    }
    cuts.retain(|&cut| top <= cut && cut <= top + (1 << 48));
    cuts.sort_unstable();
    cuts.dedup();
    let twice: i128 = cuts.windows(2).map(|two| (two[1] - two[0]) * widths(&sides, rule, left, (two[0], two[1]))).sum();
    twice >> 41
}

/// What is covered of the upper border of a strip in a pixel, and of its lower one.
fn widths(sides: &[Strip], rule: FillRule, left: i128, (top, bottom): (i128, i128)) -> i128 {
    let mut active: Vec<_> = sides.iter().filter(|side| side.spans(top, bottom)).collect();
    active.sort_by_key(|side| side.at(top) + side.at(bottom));
    let (mut winding, mut sum) = (0, 0);
    for side in active {
        let is_inside = |winding: i32| match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding % 2 != 0,
        };
        let before = is_inside(winding);
        winding += side.winding;
        let borders: i128 = [top, bottom].map(|v| (side.at(v) - left).clamp(0, 1 << 48)).iter().sum();
        match (before, is_inside(winding)) {
            (false, true) => sum -= borders,
            (true, false) => sum += borders,
            _ => {}
        }
    }
    sum
}

/// A side that meets a row, downwards, in units; heights and places along it are in `2^-40` of them.
struct Strip {
    a: (i128, i128),
    by: (i128, i128),
    winding: i32,
}

impl Strip {
    fn new(a: Units, b: Units, (top, bottom): (i128, i128)) -> Option<Self> {
        let (a, b, winding) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
        let [a, b] = [crate::wide(a), crate::wide(b)];
        let meets = a.1 < b.1 && a.1 << 40 < bottom && b.1 << 40 > top;
        meets.then_some(Self { a, by: (b.0 - a.0, b.1 - a.1), winding })
    }

    fn spans(&self, top: i128, bottom: i128) -> bool {
        self.a.1 << 40 <= top && bottom <= (self.a.1 + self.by.1) << 40
    }

    fn at(&self, v: i128) -> i128 {
        (self.a.0 << 40) + ((v - (self.a.1 << 40)) * self.by.0).div_euclid(self.by.1)
    }

    fn row_of(&self, x: i128) -> Option<i128> {
        let along = x - (self.a.0 << 40);
        (self.by.0 != 0).then(|| (self.a.1 << 40) + (along * self.by.1).div_euclid(self.by.0))
    }

    /// The height at which the lines of two sides cross.
    fn crossing(&self, other: &Self) -> Option<i128> {
        let cross = self.by.0 * other.by.1 - other.by.0 * self.by.1;
        // From the upper end of this one: how far the other line is to the right there, times its height.
        let (x, y) = (other.a.0 - self.a.0, other.a.1 - self.a.1);
        let apart = (x * other.by.1 - y * other.by.0) * self.by.1;
        (cross != 0).then(|| (self.a.1 << 40) + (apart << 40).div_euclid(cross))
    }
}

/// The sides of closed contours.
pub fn sides(contours: &[Vec<Units>]) -> impl Iterator<Item = (Units, Units)> + '_ {
    contours.iter().flat_map(|contour| (0..contour.len()).map(|i| (contour[i], contour[(i + 1) % contour.len()])))
}

fn side_area(a: Units, b: Units, (x, y): (i32, i32)) -> i128 {
    let (a, b, winding) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
    let [(ax, ay), (bx, by)] = [crate::wide(a), crate::wide(b)];
    let (left, top) = (i128::from(x) * 256, i128::from(y) * 256);
    let (dx, dy) = (bx - ax, by - ay);
    let (y0, y1) = (ay.max(top), by.min(top + 256));
    if y0 >= y1 {
        return 0;
    }
    if dx == 0 {
        let right = (left + 256 - ax).clamp(0, 256);
        return winding * ((right * (y1 - y0)) << 40);
    }
    // Of the ends of the part in this row, x - left times dy.
    let along = |v: i128| (ax - left) * dy + (v - ay) * dx;
    let (p0, p1) = (along(y0), along(y1));
    // Left of the pixel: the whole width counts. The height of that part is its width times dy / dx, and widths are times dy here.
    let before = |p: i128| p.min(0);
    let outside = ((before(p1) - before(p0)) * 256) << 40;
    // Inside: the integral of (256 - t) dt from t0 to t1, times dy / dx. With u = t dy it is (512 u dy - u^2) / (2 dy dx).
    let inside = |p: i128| {
        let u = p.clamp(0, 256 * dy);
        512 * u * dy - u * u
    };
    let inside = inside(p1) - inside(p0);
    winding * (outside / dx + fraction(inside, 2 * dy * dx))
}

/// `2^40 n / d` for numbers so large that the product does not fit.
fn fraction(n: i128, d: i128) -> i128 {
    let (mut result, mut rest) = (n / d, n % d);
    for _ in 0..4 {
        rest <<= 10;
        result = (result << 10) + rest / d;
        rest %= d;
    }
    result
}

/// The level of an area: 255ths of a pixel, rounded to nearest.
pub fn level(area: i128) -> u8 {
    ((area * 255 + PIXEL / 2) / PIXEL) as u8
}

/// A picture of levels, one byte a pixel: a sink for shapes with coverage. Each pixel may be told once, inside of the window, rows
/// from the top down and columns from left to right.
#[derive(Clone, PartialEq, Eq)]
pub struct Levels {
    /// What it shows.
    pub window: Rect,
    /// Row by row.
    pub levels: Vec<u8>,
    /// How many pixels were told by plain spans.
    pub plain: usize,
    /// How many times it was told something.
    pub calls: usize,
    next: (i32, i32),
}

impl Levels {
    /// Nothing covered.
    pub fn new(window: Rect) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        Self { window, levels: vec![0; pixels], plain: 0, calls: 0, next: (i32::MIN, 0) }
    }

    /// The level of a pixel.
    pub fn at(&self, x: i32, y: i32) -> u8 {
        self.levels[self.place(x, y)]
    }

    fn place(&self, x: i32, y: i32) -> usize {
        let window = self.window;
        assert!(window.contains(x, y), "({x}, {y}) is not in {window:?}");
        let (right, down) = (x.wrapping_sub(window.x0) as u32, y.wrapping_sub(window.y0) as u32);
        down as usize * window.width() as usize + right as usize
    }

    fn put(&mut self, span: ClippedSpan, level: impl Fn(usize) -> u8) {
        self.calls += 1;
        let start = (span.y(), span.x0());
        assert!(self.next <= start, "{span:?} after {:?}: not in order, or twice", self.next);
        self.next = (span.y(), span.x1());
        for (i, x) in (span.x0()..span.x1()).enumerate() {
            let place = self.place(x, span.y());
            self.levels[place] = level(i);
        }
    }

    /// As text: levels in hexadecimal digits.
    pub fn picture(&self) -> String {
        let rows = self.levels.chunks(self.window.width().max(1) as usize);
        rows.map(|row| row.iter().map(|level| format!("{level:02x}")).collect::<Vec<_>>().join(" ") + "\n").collect()
    }
}

impl Sink for &mut Levels {
    fn span(&mut self, span: ClippedSpan) {
        self.plain += span.len() as usize;
        self.put(span, |_| 255);
    }

    fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
        assert_eq!(span.len() as usize, levels.len(), "levels of {span:?}");
        assert!(!levels.contains(&0), "{span:?} names pixels that are not covered: {levels:?}");
        self.put(span, |i| levels[i]);
    }
}

/// How far a cubic curve goes from the lines that stand for it, in units, as samples of it show. It goes along them from the first
/// to the last.
pub fn distance_of_curve(points: [Units; 4], lines: &[Units]) -> f64 {
    let p = points.map(|(x, y)| (f64::from(x), f64::from(y)));
    let at = |t: f64| {
        let s = 1.0 - t;
        let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        let sum = |of: fn((f64, f64)) -> f64| weights.iter().zip(p).map(|(w, p)| w * of(p)).sum::<f64>();
        (sum(|p| p.0), sum(|p| p.1))
    };
    let samples = lines.len() * 8;
    let mut worst = 0.0_f64;
    for i in 0..=samples {
        let q = at(i as f64 / samples as f64);
        let near = lines.windows(2).map(|line| distance_of_side(q, line[0], line[1])).fold(f64::MAX, f64::min);
        worst = worst.max(near);
    }
    worst
}

fn distance_of_side(q: (f64, f64), a: Units, b: Units) -> f64 {
    let (a, b) = ((f64::from(a.0), f64::from(a.1)), (f64::from(b.0), f64::from(b.1)));
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    let t = if square == 0.0 { 0.0 } else { (((q.0 - a.0) * dx + (q.1 - a.1) * dy) / square).clamp(0.0, 1.0) };
    (q.0 - a.0 - t * dx).hypot(q.1 - a.1 - t * dy)
}
