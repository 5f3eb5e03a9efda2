//! Packed paths: what the packer of the simulator writes is read again, and draws the same; and any bytes, by the table of commands.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "small numbers, and random ones"
)]

use embedded_graphics_core::pixelcolor::BinaryColor;
use embedded_raster::{
    fixed::types::I16F16,
    Affine, Canvas, EdgeSlot, Error, FillRule, PackedError, PackedFault, PackedPath, Path,
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx, Rect,
};
use embedded_raster_simulator::svg::pack;
use twins::{
    curves::{random_path, segments},
    hits::Hits,
    packed::read,
    rng::{cases, Rng},
    scenes::Scale,
};

fn packed(path: impl IntoIterator<Item = PathSegment>, tolerance: u32) -> Vec<u8> {
    pack(path, tolerance).expect("near enough")
}

/// Within no tolerance at all, nothing changes: in every size, and at the ends of the type.
#[test]
fn paths_come_back() {
    let mut rng = Rng::new(2_120);
    let mut bytes = [0, 0];
    for i in 0..cases(8_000) {
        let scale = Scale::ALL[i % 3];
        let path = segments(&random_path(&mut rng, scale, 3));
        let coarse = rng.pick(&[1, 1, 4, 64, 256]);
        let onto = |at: PointFx| PointFx::from_bits(at.x.to_bits() / coarse * coarse, at.y.to_bits() / coarse * coarse);
        let path: Vec<PathSegment> = path
            .into_iter()
            .map(|segment| match segment {
                MoveTo(a) => MoveTo(onto(a)),
                LineTo(a) => LineTo(onto(a)),
                QuadraticTo(c, a) => QuadraticTo(onto(c), onto(a)),
                CubicTo(c, d, a) => CubicTo(onto(c), onto(d), onto(a)),
                Close => Close,
            })
            .collect();
        let text = packed(path.iter().copied(), 0);
        let got: Vec<PathSegment> = Path::packed(&text).expect("a path").iter().collect();
        let has_move = matches!(path.first(), Some(MoveTo(_)) | None);
        let wanted: Vec<PathSegment> =
            (!has_move).then(|| MoveTo(PointFx::px(0, 0))).into_iter().chain(path.iter().copied()).collect();
        assert_eq!(got, wanted, "{text:?}");
        assert_eq!(read(&text), Ok(wanted), "{text:?}");
        bytes = [bytes[0] + text.len(), bytes[1] + got.len() * size_of::<PathSegment>()];
    }
    assert!(bytes[0] < bytes[1], "{bytes:?}");
}

/// No place is farther off than was allowed, whatever is rounded on the way.
#[test]
fn places_are_as_near_as_was_asked_for() {
    let mut rng = Rng::new(2_121);
    for _ in 0..cases(8_000) {
        let path = segments(&random_path(&mut rng, Scale::Screen, 3));
        let tolerance = rng.pick(&[0, 1, 5, 20, 128, 200]);
        let bytes = packed(path.iter().copied(), tolerance);
        let got: Vec<PathSegment> = Path::packed(&bytes).expect("a path").iter().collect();
        let places = |segment: PathSegment| match segment {
            MoveTo(a) | LineTo(a) => vec![a],
            QuadraticTo(c, a) => vec![c, a],
            CubicTo(c, d, a) => vec![c, d, a],
            Close => vec![],
        };
        let more = got.len() - path.len();
        for (a, b) in got[more..].iter().zip(&path) {
            for (a, b) in places(*a).into_iter().zip(places(*b)) {
                let off = a.x.to_bits().abs_diff(b.x.to_bits()).max(a.y.to_bits().abs_diff(b.y.to_bits()));
                assert!(off <= tolerance, "{off} of {tolerance}: {a:?} for {b:?}, {bytes:?}");
            }
        }
    }
}

#[test]
fn every_command() {
    let p = PointFx::px;
    let path = [
        MoveTo(p(1, 2)),
        LineTo(p(5, 2)),
        LineTo(p(5, 9)),
        LineTo(p(3, 3)),
        QuadraticTo(p(4, 4), p(6, 3)),
        CubicTo(p(7, 3), p(8, 4), p(9, 6)),
        CubicTo(p(10, 8), p(8, 9), p(7, 7)),
        Close,
        LineTo(p(1, 1)),
    ];
    let bytes = packed(path, 0);
    assert_eq!(bytes.len(), 1 + 2 + 2 + 2 + 2 + 3 + 4 + 2 + 1 + 2, "{bytes:02x?}");
    assert!(Path::packed(&bytes).unwrap().into_iter().eq(path), "{bytes:02x?}");
    let moved = Affine::translate(I16F16::from_num(0.25), I16F16::from_num(-3));
    assert!(Path::packed(&bytes).unwrap().mapped(moved).eq(moved.path(path)), "mapped");
}

#[test]
fn errors_have_their_position() {
    use PackedFault::{Command, Cut, Fraction, Move};
    for (bytes, position, fault) in [
        (&[][..], 0, Fraction),
        (&[9], 0, Fraction),
        (&[0, 0], 1, Move),
        (&[0, 0x40, 0], 1, Move),
        (&[0, 1], 1, Command),
        (&[0, 0x20], 1, Cut),
        (&[0, 0x20, 0, 0x1f], 3, Command),
        (&[8, 0x3f, 0, 0, 0, 0, 0, 0, 0], 1, Cut),
        (&[8, 0x20, 0, 0xc7, 0, 0, 0, 0, 0], 3, Cut),
    ] {
        assert_eq!(Path::packed(bytes), Err(PackedError { position, fault }), "{bytes:?}");
        assert_eq!(read(bytes), Err(position), "{bytes:?}");
    }
    assert!(Path::packed(&[3]).is_ok_and(PackedPath::is_empty));
    let error = Error::from(Path::packed(&[0, 0x1f]).unwrap_err());
    assert_eq!(error.to_string(), "byte 1: there is no such command");
}

/// Found when a program is compiled.
#[test]
fn bytes_are_checked_when_a_program_is_compiled() {
    const BYTES: &[u8] = &[1, 0x22, 0b0110_1000, 0x63, 0x70, 0];
    const PATH: PackedPath<'static> = match Path::packed(BYTES) {
        Ok(path) => path,
        Err(_) => panic!("no packed path"),
    };
    const LEN: usize = PATH.len();
    const WRONG: bool = Path::packed(&[1, 0x22]).is_err();
    assert_eq!((LEN, WRONG, PATH.bytes()), (3, true, BYTES));
    let half = PointFx::from_bits;
    assert!(PATH.iter().eq([MoveTo(half(384, 256)), LineTo(half(384 + 896, 256)), Close]));
}

/// Random bytes: as the table says, and drawn as the segments that they stand for.
#[test]
fn any_bytes() {
    let mut rng = Rng::new(2_122);
    let (mut valid, window) = (0, Rect::new(-9, -9, 30, 30));
    for _ in 0..cases(40_000) {
        let mut bytes: Vec<u8> = (0..rng.below(40)).map(|_| rng.bits() as u8).collect();
        if let [fraction, first, ..] = &mut bytes[..] {
            (*fraction, *first) = (*fraction % 9, 32 | *first & 15);
        }
        if let Err(error) = Path::packed(&bytes) {
            assert_eq!(read(&bytes), Err(error.position), "{bytes:?}");
            bytes.truncate(error.position);
        }
        let Ok(path) = Path::packed(&bytes) else { continue };
        let wanted = read(&bytes).unwrap_or_else(|position| panic!("byte {position} of {bytes:?}"));
        assert!(path.iter().eq(wanted.iter().copied()), "{bytes:?}");
        let (mut hits, mut others) = (Hits::new(window), Hits::new(window));
        hits.draw_path_fx(path, BinaryColor::On);
        others.draw_path_fx(Path::new(&wanted), BinaryColor::On);
        let all = |hits: &Hits| {
            (-9..30).flat_map(|y| (-9..30).map(move |x| (x, y))).map(|(x, y)| hits.count(x, y)).collect::<Vec<_>>()
        };
        assert_eq!(all(&hits), all(&others), "{bytes:?}");
        let mut table = vec![EdgeSlot::EMPTY; 60];
        let filled = hits.fill_path_fx(path, FillRule::NonZero, &mut table, BinaryColor::On).is_ok();
        valid += usize::from(filled && wanted.len() > 2);
    }
    assert!(valid > cases(5_000), "{valid}");
}

/// Icons of 24 pixels: bytes beside those of the text.
#[test]
fn icons_take_about_half_of_their_text() {
    let icons = include_str!("../assets/feather.txt");
    let (mut count, mut text, mut bytes, mut exact) = (0, 0, 0, 0);
    for (name, data) in icons.lines().filter_map(|line| line.split_once('\t')) {
        let path = Path::svg(data).unwrap_or_else(|error| panic!("{name}: {error}"));
        let short = packed(path, 5);
        assert!(Path::packed(&short).unwrap().len() == path.len(), "{name}");
        (count, text, bytes) = (count + 1, text + data.len(), bytes + short.len());
        exact += packed(path, 0).len();
    }
    assert_eq!((count, text, bytes, exact), (41, 4_456, 2_424, 3_128), "of text, within 0.02 pixel, to 1/256");
}
