//! Drop-out control against its rules, word for word.

use std::collections::BTreeSet;

use embedded_raster::{
    raster::polygon::{
        drop_out::{self, DropOut},
        edge_slots, fill,
    },
    ClippedSpan, EdgeSlot, EdgeTableFull, FillRule, PointFx, Rect,
};
use twins::{
    drop_outs,
    rng::{cases, Rng},
    Units,
};

const ALL: [DropOut; 4] =
    [DropOut::SIMPLE, DropOut::SIMPLE_WITHOUT_STUBS, DropOut::SMART, DropOut::SMART_WITHOUT_STUBS];

fn places(contours: &[Vec<Units>]) -> Vec<Vec<PointFx>> {
    contours.iter().map(|contour| contour.iter().map(|&(x, y)| PointFx::from_bits(x, y)).collect()).collect()
}

fn drawn(
    contours: &[Vec<Units>],
    rule: FillRule,
    drop_out: DropOut,
    slots: usize,
    window: Rect,
) -> Result<BTreeSet<(i32, i32)>, EdgeTableFull> {
    let (mut table, mut pixels) = (vec![EdgeSlot::EMPTY; slots], BTreeSet::new());
    drop_out::fill(&places(contours), rule, drop_out, &mut table, window, |s: ClippedSpan| {
        assert!((window.y0..window.y1).contains(&s.y()) && window.x0 <= s.x0() && s.x1() <= window.x1, "{s:?}");
        for x in s.x0()..s.x1() {
            assert!(pixels.insert((s.y(), x)), "({x}, {}) comes again, {drop_out:?}: {contours:?}", s.y());
        }
    })?;
    Ok(pixels)
}

fn check(contours: &[Vec<Units>], rule: FillRule, drop_out: DropOut, slots: usize, window: Rect) -> [usize; 2] {
    let [inside, on] = drop_outs::pixels(contours, rule, drop_out, window);
    let wanted: BTreeSet<_> = inside.union(&on).copied().collect();
    let got = drawn(contours, rule, drop_out, slots, window).expect("enough slots");
    assert_eq!(got, wanted, "{drop_out:?}, {rule:?}, {window:?}, {slots} slots: {contours:?}");
    [inside.len(), on.difference(&inside).count()]
}

fn random(rng: &mut Rng) -> Vec<Vec<Units>> {
    let coarse = rng.pick(&[1, 1, 32, 64, 128]);
    let place = |rng: &mut Rng| (rng.int(-600, 3_000) / coarse * coarse, rng.int(-600, 3_000) / coarse * coarse);
    (0..rng.int(1, 3))
        .map(|_| {
            let a = place(rng);
            match rng.below(3) {
                // Thin, in any direction.
                0 => {
                    let (b, w) = (place(rng), (rng.int(-150, 150), rng.int(-150, 150)));
                    vec![a, b, (b.0 + w.0, b.1 + w.1), (a.0 + w.0, a.1 + w.1)]
                }
                // Small.
                1 => (0..rng.int(1, 5)).map(|_| (a.0 + rng.int(-200, 200), a.1 + rng.int(-200, 200))).collect(),
                _ => (0..rng.int(2, 7)).map(|_| place(rng)).collect(),
            }
        })
        .collect()
}

#[test]
fn pixels_are_those_of_the_rules() {
    let mut rng = Rng::new(1_330);
    let mut sums = [0, 0];
    for i in 0..cases(6_000) {
        let contours = random(&mut rng);
        let (x, y) = (rng.int(-3, 6), rng.int(-3, 6));
        let window = Rect::new(x, y, x + rng.int(1, 12), y + rng.int(1, 12));
        let rule = rng.pick(&[FillRule::NonZero, FillRule::EvenOdd]);
        let slots = rng.pick(&[64, 64, 24]);
        let [inside, on] = check(&contours, rule, ALL[i % 4], slots, window);
        sums = [sums[0] + inside, sums[1] + on];
    }
    assert!(sums[0] > cases(10_000) && sums[1] > cases(1_000), "{sums:?}: too easy");
}

/// Far outside of the window, and as large as crossings are exact.
#[test]
fn large_shapes_too() {
    let mut rng = Rng::new(1_331);
    for i in 0..cases(2_000) {
        let place = |rng: &mut Rng| {
            let far = |rng: &mut Rng| rng.int(-(1 << 23), 1 << 23) >> rng.int(0, 16);
            (far(rng), far(rng))
        };
        let (a, b) = (place(&mut rng), place(&mut rng));
        let w = (rng.int(-99, 99), rng.int(-99, 99));
        let thin = vec![a, b, (b.0 + w.0, b.1 + w.1), (a.0 + w.0, a.1 + w.1)];
        check(&[thin], FillRule::NonZero, ALL[i % 4], 8, Rect::new(-6, -6, 6, 6));
    }
}

#[test]
fn a_thin_stem_is_one_column() {
    // From x = 3.55 to 4.15, and from y = 1 to 6.
    let stem = [vec![(909, 256), (1_062, 256), (1_062, 1_536), (909, 1_536)]];
    let window = Rect::new(0, 0, 9, 9);
    let mut plain = 0;
    let mut table = [EdgeSlot::EMPTY; 4];
    fill(&places(&stem), FillRule::NonZero, &mut table, window, |s: ClippedSpan| plain += s.len()).unwrap();
    assert_eq!(plain, 0, "between two columns");
    let column = |rows: std::ops::Range<i32>| rows.map(|y| (y, 3)).collect::<BTreeSet<_>>();
    for drop_out in ALL {
        let got = drawn(&stem, FillRule::NonZero, drop_out, 4, window).unwrap();
        // Its ends are no stubs: they lie between rows, so that the next row is not crossed.
        let rows = if drop_out.stubs { 1..6 } else { 2..5 };
        assert_eq!(got, column(rows), "{drop_out:?}");
    }
    let right = [vec![(960, 256), (1_140, 256), (1_140, 1_536), (960, 1_536)]];
    let got = drawn(&right, FillRule::NonZero, DropOut::SMART, 4, window).unwrap();
    assert_eq!(got, (1..6).map(|y| (y, 4)).collect(), "the middle, 4.1, is nearer to column 4");
}

/// A pixel that both of its neighbours in the row turn on, and one that is turned on along its row and along its column.
#[test]
fn each_pixel_comes_once() {
    let dot = |x: i32, y: i32| vec![(x, y), (x + 40, y), (x + 40, y + 200), (x, y + 200)];
    let window = Rect::new(0, 0, 5, 5);
    // Left and right of the centre of (2, 2), and nearer to it than to its neighbours.
    let beside = [dot(2 * 256 + 30, 600), dot(2 * 256 + 180, 600)];
    assert_eq!(drawn(&beside, FillRule::NonZero, DropOut::SMART, 8, window), Ok([(2, 2)].into()));
    // A cross whose bars lie between the centres of rows and of columns.
    let cross =
        [vec![(650, 500), (690, 500), (690, 690), (650, 690)], vec![(500, 650), (690, 650), (690, 690), (500, 690)]];
    for drop_out in ALL {
        let got = drawn(&cross, FillRule::NonZero, drop_out, 16, window).expect("enough slots");
        assert!(!drop_out.stubs || !got.is_empty(), "{drop_out:?}");
    }
}

#[test]
fn what_does_not_fit_is_not_begun() {
    let tooth = |i| vec![(300 * i, 200 * i), (300 * i + 99, 200 * i), (300 * i + 50, 200 * i + 600)];
    let comb: Vec<Vec<Units>> = (0..9).map(tooth).collect();
    let window = Rect::new(0, 0, 12, 9);
    let needs = drop_out::edge_slots(&places(&comb), window);
    assert!(needs.least < needs.whole && needs.whole >= edge_slots(&places(&comb), window).whole, "{needs:?}");
    for slots in 0..needs.whole + 2 {
        match drawn(&comb, FillRule::NonZero, DropOut::SMART, slots, window) {
            Ok(got) => {
                let all = drawn(&comb, FillRule::NonZero, DropOut::SMART, 99, window).unwrap();
                assert!(got == all && slots >= needs.least, "{slots} slots");
            }
            Err(error) => assert!(slots < needs.least && error.capacity == slots, "{error:?}"),
        }
    }
}
