//! Arcs and turned ellipses against the formulas of SVG in floats.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "twins in wide integers and floats")]

use embedded_raster::{
    fixed::types::{I16F16, I24F8},
    geom::{Arc, Curves},
    px, Affine, Angle,
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo},
    PointFx,
};
use twins::{
    arcs::{self, Centred, Place},
    rng::{cases, Rng},
};

fn pixels(place: PointFx) -> Place {
    [place.x.to_num(), place.y.to_num()]
}

/// Places of cubic curves, 16 for each.
fn samples(from: Place, curves: impl IntoIterator<Item = PathSegment>) -> Vec<Place> {
    let (mut at, mut all) = (from, vec![]);
    for segment in curves {
        let CubicTo(c, d, to) = segment else { panic!("{segment:?} is no cubic curve") };
        let [c, d, to] = [c, d, to].map(pixels);
        all.extend((0..=16).map(|i| {
            let t = f64::from(i) / 16.0;
            let s = 1.0 - t;
            [0, 1].map(|k| s.powi(3) * at[k] + 3.0 * s * s * t * c[k] + 3.0 * s * t * t * d[k] + t.powi(3) * to[k])
        }));
        at = to;
    }
    all
}

/// Each place is near the ellipse, and further along it than those before.
fn check(ellipse: &Centred, places: &[Place], allowed: f64, what: &str) {
    let longest = ellipse.radii[0].max(ellipse.radii[1]);
    // A unit of 1/256 pixel, as an angle where the ellipse is bent most.
    let slack = (allowed + 1.0 / 256.0) / ellipse.radii[0].min(ellipse.radii[1]) / ellipse.angles[1].abs();
    let mut last = -slack;
    for &place in places {
        let far = ellipse.distance(place);
        assert!(far <= allowed, "{far} px from the ellipse of {longest} px at {place:?}: {what}");
        let done = ellipse.progress(place);
        assert!(done >= last - 2.0 * slack && done <= 1.0 + 2.0 * slack, "{done} after {last} at {place:?}: {what}");
        last = last.max(done);
    }
}

struct Case {
    arc: Arc,
    from: PointFx,
    to: PointFx,
}

impl Case {
    fn twin(&self) -> arcs::Arc {
        let Arc { radii, rotation, is_large, is_clockwise } = self.arc;
        let degrees = f64::from(rotation.to_bits()) / 4_294_967_296.0 * 360.0;
        arcs::Arc { radii: radii.map(|r| r.to_num()), degrees, is_large, is_clockwise }
    }

    fn reversed(&self) -> Vec<PathSegment> {
        let arc = Arc { is_clockwise: !self.arc.is_clockwise, ..self.arc };
        let mut at = self.to;
        let mut back: Vec<_> = arc
            .between(self.to, self.from)
            .map(|segment| {
                let CubicTo(c, d, to) = segment else { panic!("{segment:?}") };
                CubicTo(d, c, std::mem::replace(&mut at, to))
            })
            .collect();
        back.reverse();
        back
    }
}

fn random(rng: &mut Rng, size: i32) -> Case {
    let place = |rng: &mut Rng| PointFx::from_bits(rng.int(-size, size), rng.int(-size, size));
    let (from, to) = (place(rng), place(rng));
    let radius = |rng: &mut Rng| I24F8::from_bits(rng.int(1, 2 * size) >> rng.int(0, 3));
    let r = radius(rng);
    let radii = if rng.one_in(2) { [r, r] } else { [r, radius(rng)] };
    let rotation = match rng.below(3) {
        0 => Angle::turns(rng.below(8) as u32, 8),
        1 => Angle::degrees(0),
        _ => Angle::from_bits(rng.bits() as u32),
    };
    Case { arc: Arc { radii, rotation, is_large: rng.one_in(2), is_clockwise: rng.one_in(2) }, from, to }
}

/// Sizes from a pixel to 30,000 of them. Near half a turn, and where both ends are nearly the same place, the centre is not
/// well known: what a place of 1/256 pixel makes of it is allowed.
#[test]
fn curves_are_near_the_ellipse() {
    let mut rng = Rng::new(1_300);
    for size in [256, 2_560, 25_600, 256_000, 7_680_000] {
        let mut most = 0;
        for _ in 0..cases(4_000) {
            let case = random(&mut rng, size);
            let Some(ellipse) = case.twin().centred(pixels(case.from), pixels(case.to)) else { continue };
            // Very flat ones have no distance that is nearly right by one step of Newton's.
            let [rx, ry] = ellipse.radii;
            if rx.max(ry) > 20.0 * rx.min(ry) || rx.max(ry) > 1e6 {
                continue;
            }
            let curves: Vec<_> = case.arc.between(case.from, case.to).collect();
            let turns = ellipse.angles[1].abs() / core::f64::consts::TAU;
            let what = format!("{:?} from {:?} to {:?}", case.arc, case.from, case.to);
            let allowed = 1.0 / 100.0 + rx.max(ry) / f64::from(1 << 26);
            check(&ellipse, &samples(pixels(case.from), curves.iter().copied()), allowed, &what);
            assert!(matches!(curves[..], [.., CubicTo(_, _, to)] if to == case.to), "{what}");
            assert_eq!(case.reversed(), curves, "back: {what}");
            assert!(curves.len() as f64 <= 1.0 + turns * 32.0, "{} curves: {what}", curves.len());
            most = most.max(curves.len());
        }
        assert!(most >= 4, "only {most} curves");
    }
}

#[test]
fn arcs_that_are_none() {
    let (a, b) = (PointFx::px(3, 4), PointFx::px(8, 16));
    let arc = Arc::circle(px(10));
    assert_eq!(arc.between(a, a).count(), 0, "from a place to itself");
    let large = Arc { is_large: true, ..arc };
    assert_eq!(large.between(a, a).count(), 0, "however large");
    for radii in [[px(0), px(9)], [px(9), px(0)], [px(0); 2]] {
        assert!(Arc { radii, ..arc }.between(a, b).eq([LineTo(b)]), "a radius of 0");
    }
    let [end, other] = [i32::MAX, i32::MIN].map(I24F8::from_bits);
    let (near, nearer) = (PointFx::from_bits(5, 5), PointFx::from_bits(6, 5));
    for radii in [[end, end], [other, other], [end, other], [I24F8::DELTA, end], [I24F8::DELTA; 2]] {
        for (is_large, is_clockwise) in [(false, false), (false, true), (true, false), (true, true)] {
            for (from, to) in [(a, b), (near, nearer), (PointFx::new(other, other), PointFx::new(end, end))] {
                for rotation in [0, 45, 90, 135, 180, 225, 270, 315, 7].map(Angle::degrees) {
                    let arc = Arc { radii, rotation, is_large, is_clockwise };
                    let curves: Vec<_> = arc.between(from, to).collect();
                    let ends = matches!(curves[..], [.., CubicTo(_, _, end) | LineTo(end)] if end == to);
                    assert!(ends && curves.len() <= 64, "{} curves, {arc:?} from {from:?} to {to:?}", curves.len());
                }
            }
        }
    }
}

/// Radii that are too small are enlarged, both by the same factor: half of the ellipse, with its centre in the middle.
#[test]
fn small_radii_are_enlarged() {
    let (a, b) = (PointFx::px(0, 0), PointFx::px(20, 0));
    let half: Vec<_> = Arc { is_clockwise: true, ..Arc::circle(px(10)) }.between(a, b).collect();
    for radius in [1, 255, 256, 2_559] {
        let arc = Arc { is_clockwise: true, ..Arc::circle(I24F8::from_bits(radius)) };
        assert!(arc.between(a, b).eq(half.iter().copied()), "radius {radius}");
        let large = Arc { is_large: true, ..arc };
        assert!(large.between(a, b).eq(half.iter().copied()), "radius {radius}, the large arc");
    }
    let top = samples(
        pixels(a),
        Arc { is_clockwise: true, ..Arc { radii: [px(1), px(3)], ..Arc::circle(px(1)) } }.between(a, b),
    );
    let highest = top.iter().map(|place| place[1]).fold(0.0, f64::min);
    assert!((highest + 30.0).abs() < 0.01, "10 wide, and 30 high: {highest}");
}

#[test]
fn ellipses_are_closed_and_turned() {
    let mut rng = Rng::new(1_301);
    for _ in 0..cases(3_000) {
        let radius = |rng: &mut Rng| rng.int(64, 100_000) >> rng.int(0, 6);
        let radii = [radius(&mut rng), radius(&mut rng)].map(|r| r.max(64));
        if radii[0] > 20 * radii[1] || radii[1] > 20 * radii[0] {
            continue;
        }
        let (rotation, centre) = (Angle::from_bits(rng.bits() as u32), PointFx::from_bits(rng.int(-9_999, 9_999), 77));
        let segments: Vec<_> = Curves::ellipse(centre, radii.map(I24F8::from_bits), rotation).collect();
        let [MoveTo(start), curves @ .., Close] = &segments[..] else { panic!("{segments:?}") };
        let degrees = f64::from(rotation.to_bits()) / 4_294_967_296.0 * 360.0;
        let radii = radii.map(|r| f64::from(r) / 256.0);
        let ellipse = Centred { centre: pixels(centre), radii, degrees, angles: [0.0, core::f64::consts::TAU] };
        let places = samples(pixels(*start), curves.iter().copied());
        let what = format!("{segments:?}");
        for place in &places {
            assert!(ellipse.distance(*place) < 0.01, "{} at {place:?} of {what}", ellipse.distance(*place));
        }
        let [u, v] = ellipse.on_circle(pixels(*start));
        assert!((u - 1.0).hypot(v) * radii[0].min(radii[1]) < 0.02, "it starts at ({u}, {v}): {what}");
        assert!(matches!(curves, [.., CubicTo(_, _, to)] if to == start), "{what}");
    }
}

/// A map that enlarges makes more pieces, and the same ellipse as one that was that large.
#[test]
fn arcs_are_mapped_before_they_are_rounded() {
    let [large, small] = [1_000, 1].map(|n| [px(2 * n), px(n)]);
    let number = I16F16::from_num::<i32>;
    let map = Affine::scale(number(1_000), number(1_000)).then(Affine::translate(number(50), number(60)));
    let turn = Angle::degrees(30);
    let mapped: Vec<_> = Curves::ellipse(PointFx::px(0, 0), small, turn).mapped(map).collect();
    let wanted: Vec<_> = Curves::ellipse(PointFx::px(50, 60), large, turn).collect();
    assert_eq!(mapped.len(), wanted.len());
    for (a, b) in mapped.iter().zip(&wanted) {
        let (CubicTo(a, ..) | MoveTo(a), CubicTo(b, ..) | MoveTo(b)) = (a, b) else { continue };
        let far = (pixels(*a)[0] - pixels(*b)[0]).hypot(pixels(*a)[1] - pixels(*b)[1]);
        // What 1/65,536 of a unit, by which N, T and each place are rounded, is a thousand times as large.
        assert!(far < 0.04, "{a:?} {b:?}");
    }
}
