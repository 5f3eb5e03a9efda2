//! SVG path data against svgtypes, another reader.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "twins in wide integers and floats")]

use std::fmt::Write;

use embedded_raster::{
    fixed::types::I16F16,
    Affine, Path,
    PathSegment::{self, Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx, Svg, SvgError, SvgExpected,
};
use twins::{
    rng::{cases, Rng},
    svgs::{self, check, place, unit},
};

fn segments(text: &str) -> Vec<PathSegment> {
    Path::svg(text).unwrap_or_else(|error| panic!("{error} in {text}")).iter().collect()
}

#[test]
fn every_command() {
    let p = PointFx::px;
    let text = "M10 20 L30 40 H50 V60 C1 2 3 4 5 6 S7 8 9 10 Q11 12 13 14 T15 16 Z";
    let wanted = [
        MoveTo(p(10, 20)),
        LineTo(p(30, 40)),
        LineTo(p(50, 40)),
        LineTo(p(50, 60)),
        CubicTo(p(1, 2), p(3, 4), p(5, 6)),
        CubicTo(p(7, 8), p(7, 8), p(9, 10)),
        QuadraticTo(p(11, 12), p(13, 14)),
        QuadraticTo(p(15, 16), p(15, 16)),
        Close,
    ];
    assert_eq!(segments(text), wanted);
    let text = "m10 20 l20 20 h20 v20 c-49-58-47-56-45-54 s2 2 4 4 q2 2 4 4 t2 2 z";
    assert_eq!(segments(text), wanted, "relative");
    assert_eq!(segments("m1 2 3 4z"), [MoveTo(p(1, 2)), LineTo(p(4, 6)), Close], "lines after a move");
    assert_eq!(segments("M1 2 3 4z"), [MoveTo(p(1, 2)), LineTo(p(3, 4)), Close], "lines after a move");
    let next = [MoveTo(p(1, 2)), LineTo(p(4, 2)), Close, LineTo(p(1, 9))];
    assert_eq!(segments("M1 2h3zv7"), next, "from the start of the contour before");
    let other = [MoveTo(p(1, 2)), LineTo(p(4, 2)), Close, MoveTo(p(2, 3))];
    assert_eq!(segments("m1 2h3zm1 1"), other, "a move from the start of the contour before");
    let corner = [MoveTo(p(0, 0)), QuadraticTo(p(4, 4), p(8, 0)), CubicTo(p(8, 0), p(9, 9), p(10, 0))];
    assert_eq!(segments("M0 0Q4 4 8 0S9 9 10 0"), corner, "S after Q does not go on smoothly");
    let corner = [MoveTo(p(0, 0)), CubicTo(p(1, 1), p(7, 1), p(8, 0)), QuadraticTo(p(8, 0), p(9, 9))];
    assert_eq!(segments("M0 0C1 1 7 1 8 0T9 9"), corner, "T after C does not go on smoothly");
    assert_eq!(segments("M4 4"), [MoveTo(p(4, 4))]);
    assert_eq!(segments(" \t\r\n\x0c"), [], "nothing");
}

#[test]
fn numbers_may_stand_close_together() {
    let at = |x: f64, y: f64| place([unit(x), unit(y)]);
    for (text, [x, y]) in [
        ("M1.5.5", [1.5, 0.5]),
        ("M1.5-2", [1.5, -2.0]),
        ("M.5.5", [0.5, 0.5]),
        ("M-.5-.5", [-0.5, -0.5]),
        ("M+1+2", [1.0, 2.0]),
        ("M1e2-1E-1", [100.0, -0.1]),
        ("M1.e1 .5e+1", [10.0, 5.0]),
        ("M 1 , 2", [1.0, 2.0]),
        ("M0.000000001 0.12345678949", [0.0, 0.123_456_789]),
        ("M0000000000000000000001 1e-400", [1.0, 0.0]),
        ("M0.0000000000000000001e19 12345678901234567890e-19", [1.0, 1.234_567_890]),
        ("M1e400 -1e99", [9e9, -9e9]),
        ("M8388607.996 -8388608", [8_388_607.996, -8_388_608.0]),
        ("M9999999999 -9999999999", [9e9, -9e9]),
    ] {
        assert_eq!(segments(text), [MoveTo(at(x, y))], "{text}");
    }
    let arcs = segments("M0 0a5 5 0 1110 0");
    assert_eq!(arcs, segments("M0 0 A 5 5 0 1 1 10 0"), "flags without spaces");
    assert_eq!(segments("M0 0a5 5 0 01.5.5"), segments("M0 0 A 5,5,0,0,1,.5,.5"), "a flag before a point");
    assert_eq!(segments("M0 0a5-5 400 0,1 3 3"), segments("M0 0a5 5 40 0,1 3 3"), "signs of radii, whole turns");
}

#[test]
fn errors_have_their_position() {
    use SvgExpected::{Command, Flag, Move, Number};
    for (text, position, expected) in [
        ("L4 4", 0, Move),
        ("Z", 0, Move),
        ("  5 5", 2, Move),
        ("#", 0, Move),
        ("é", 0, Move),
        ("X", 0, Move),
        ("M", 1, Number),
        ("M4", 2, Number),
        ("M4 ", 3, Number),
        ("M,4 4", 1, Number),
        ("M4,,4", 3, Number),
        ("M4 4,", 5, Number),
        ("M4 4 L", 6, Number),
        ("M4 4 5", 6, Number),
        ("M4 4 X5", 5, Command),
        ("M4 4 é", 5, Number),
        ("M4 4zz 5", 7, Command),
        ("M4 4z,", 5, Command),
        ("M4 4 1e", 6, Number),
        ("M4 4 1 1e", 8, Command),
        ("M4 4--1", 4, Number),
        ("M4 4 .", 5, Number),
        ("M4 4 - 1", 5, Number),
        ("M0 0A1 1 0 2 0 5 5", 11, Flag),
        ("M0 0A1 1 0 01", 13, Number),
        ("M0 0A1 1 0 0", 12, Flag),
        ("M0 0C1 2 3 4 5", 14, Number),
        ("M4 4\u{a0}L5 5", 4, Number),
    ] {
        let Err(error) = Path::svg(text) else { panic!("{text} makes sense") };
        assert_eq!((error.position, error.expected), (position, expected), "{text}");
    }
    assert_eq!(Path::svg("M4 4 L").unwrap_err().to_string(), "position 6: a number is expected");
}

fn number(rng: &mut Rng) -> String {
    let sign = rng.pick(&["", "", "-", "+"]);
    let size = rng.int(0, 999);
    let digits = rng.int(0, 99_999);
    match rng.below(8) {
        0 => format!("{sign}{size}"),
        1 => format!("{sign}.{digits}"),
        2 => format!("{sign}{size}e-{}", rng.below(5)),
        3 => format!("{sign}{size}.{digits}E+{}", rng.below(3)),
        4 => format!("{sign}00{size}.{digits:05}"),
        5 => format!("{sign}0"),
        _ => format!("{sign}{size}.{digits}"),
    }
}

fn random_text(rng: &mut Rng, commands: usize) -> String {
    let mut text = String::from(rng.pick(&["M", "m", " M", "\nm "]));
    let space = |rng: &mut Rng| rng.pick(&[" ", ",", " , ", "\n", "  ", "\t"]);
    let put = |rng: &mut Rng, text: &mut String, first: bool| {
        let next = number(rng);
        if first {
            text.push_str(rng.pick(&["", " ", "\n"]));
        } else if rng.one_in(2) || !next.starts_with(['-', '+']) {
            // Needed between digits; not before a point if there was one.
            let last = text.rsplit(|c: char| !c.is_ascii_digit() && c != '.').next().unwrap_or_default();
            let exponent = text.trim_end_matches(|c: char| c.is_ascii_digit()).ends_with(['e', 'E', '-', '+']);
            if !(next.starts_with('.') && last.contains('.') && !exponent) || rng.one_in(2) {
                text.push_str(space(rng));
            }
        }
        text.push_str(&next);
    };
    for i in 0..2 {
        put(rng, &mut text, i == 0);
    }
    for _ in 0..commands {
        let letter = rng.pick(&['m', 'l', 'h', 'v', 'c', 's', 'q', 't', 'a', 'z']);
        text.push(if rng.one_in(2) { letter } else { letter.to_ascii_uppercase() });
        let count = match letter {
            'z' => 0,
            'h' | 'v' => 1,
            's' | 'q' => 4,
            'c' => 6,
            'a' => 7,
            _ => 2,
        };
        for again in 0..if count > 0 { rng.int(1, 3) } else { 0 } {
            for i in 0..count {
                if count == 7 && (i == 3 || i == 4) {
                    let before = if i == 3 { space(rng) } else { rng.pick(&["", " ", ","]) };
                    write!(text, "{before}{}", rng.below(2)).unwrap();
                    if i == 4 {
                        text.push_str(rng.pick(&["", " ", ","]));
                        text.push_str(&number(rng));
                    }
                } else if count != 7 || i != 5 {
                    put(rng, &mut text, i == 0 && again == 0);
                }
            }
        }
    }
    text
}

#[test]
fn random_paths_are_those_of_another_reader() {
    let mut rng = Rng::new(1_320);
    let (mut arcs, mut read) = (0, 0);
    for round in 0..cases(20_000) {
        let text = random_text(&mut rng, if round % 1_000 == 0 { 7_000 } else { 6 });
        let wanted = svgs::read(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
        let got = segments(&text);
        let mut rest = got.iter().copied();
        for (i, step) in wanted.iter().enumerate() {
            match *step {
                Ok(step) => {
                    assert_eq!(rest.next(), Some(step), "command {i} of {text}");
                    read += 1;
                }
                Err([from, to]) if from == to => {}
                Err([_, to]) => {
                    let is_end = |segment| matches!(segment, CubicTo(_, _, end) | LineTo(end) if end == place(to));
                    assert!(rest.any(is_end), "command {i} of {text}");
                    arcs += 1;
                }
            }
        }
        assert_eq!(rest.next(), None, "{text}");
        assert_eq!(Path::svg(&text).unwrap().len(), got.len());
    }
    assert!(arcs > 1_000 && read > 10_000, "{arcs} {read}");
}

/// Cut somewhere, or with another character somewhere, a text makes sense to both or to none. Only svgtypes takes a comma behind
/// the last argument of a command.
#[test]
fn broken_paths_are_those_of_another_reader() {
    let mut rng = Rng::new(1_321);
    let (mut broken, mut whole) = (0, 0);
    for _ in 0..cases(40_000) {
        let mut text = random_text(&mut rng, 3).into_bytes();
        let at = rng.index(text.len());
        if rng.one_in(2) {
            text.truncate(at);
        } else {
            text[at] = rng.pick(b"MmLzZaA,.-+0199 eExX#\n");
        }
        let text = String::from_utf8(text).unwrap();
        let (got, wanted) = (Path::svg(&text), svgs::read(&text));
        if wanted.is_ok() {
            let has_comma = |error: SvgError| text[..error.position].trim_end().ends_with(',');
            assert!(got.is_ok() || got.is_err_and(has_comma), "{got:?}: {text}");
            whole += 1;
        } else {
            broken += 1;
        }
        if let Err(error) = got {
            assert!(error.position <= text.len());
        }
    }
    assert!(broken.min(whole) > cases(40_000) / 8, "{broken} {whole}");
}

/// What is found when a program is compiled is found when it runs.
#[test]
fn texts_are_the_same_when_a_program_is_compiled() {
    macro_rules! check {
        ($($text:literal)*) => {$(
            const FOUND: Result<usize, (usize, SvgExpected)> = match Path::svg($text) {
                Ok(path) => Ok(path.len()),
                Err(SvgError { position, expected }) => Err((position, expected)),
            };
            let text = std::hint::black_box(String::from($text));
            let found = Path::svg(&text).map(Svg::len).map_err(|error| (error.position, error.expected));
            assert_eq!(FOUND, found, "{text}");
            if FOUND.is_ok() {
                // As many segments as it has, made when the program is compiled.
                const SEGMENTS: [PathSegment; match FOUND { Ok(len) => len, Err(_) => 0 }] = match Path::svg($text) {
                    Ok(path) => path.to_array().unwrap(),
                    Err(_) => [PathSegment::Close; match FOUND { Ok(len) => len, Err(_) => 0 }],
                };
                assert_eq!(SEGMENTS[..], segments(&text), "{text}");
            }
        )*};
    }
    {
        check!("M4 4h16l-8 12z");
    }
    {
        check!("m1.5.5-2e-1,3 7 8zM1 2q3 4 5 6t7 8");
    }
    {
        check!("M0 0a5 3 30 1 1 8 6A5 5 0 0 0 1 1");
    }
    {
        check!("M1 2c1 2 3 4 5 6s7 8 9 10S1 1 2 2v9H3");
    }
    {
        check!("M1e9 -1e9L1e-9 123456789.123456789123");
    }
    {
        check!("M4 4 L20,");
    }
    {
        check!("M4 4 a1 1 0 2 0 5 5");
    }
    {
        check!("é");
    }
    {
        check!("");
    }
}

/// Any text, and what of it makes sense.
#[test]
fn any_text_is_read_as_another_reader_does() {
    let mut rng = Rng::new(1_323);
    let letters = b"MmLlHhVvCcSsQqTtAaZz0123456789.-+eE,, \n";
    // Commands with the numbers that they take, more or less, and letters in any order.
    let commands = [("Mm", 2), ("Ll", 2), ("Hh", 1), ("Vv", 1), ("Cc", 6), ("Ss", 4), ("Qq", 4), ("Tt", 2), ("Zz", 0)];
    let mut valid = 0;
    for _ in 0..cases(60_000) {
        let mut text = String::from(rng.pick(&["M1 2", "m.5-3", "M 7,8.25"]));
        for _ in 0..rng.below(6) {
            let (names, numbers) = rng.pick(&commands);
            text.push(char::from(names.as_bytes()[rng.below(2) as usize]));
            for _ in 0..(numbers + u64::from(rng.one_in(40))) {
                text.push_str(rng.pick(&[" ", ",", "\n ", "-", " +"]));
                text.push_str(rng.pick(&["1", "20", ".5", "3.25", "7e1", "12.5e-1", "0", "4."]));
            }
        }
        if rng.one_in(3) {
            text.extend((0..rng.below(40)).map(|_| char::from(rng.pick(letters))));
        }
        check(&text);
        let end = Path::svg(&text).map_or_else(|error| error.position, |_| text.len());
        let front = &text[..text[..end].rfind(|c: char| c.is_ascii_alphabetic() && !"eE".contains(c)).unwrap_or(0)];
        valid += usize::from(check(front) && front.len() > 10);
    }
    assert!(valid > cases(2_000), "{valid}");
}

#[test]
fn texts_become_arrays_when_a_program_is_compiled() {
    const DROP: Svg = match Path::svg("M8 0c0 6 5 7 5 11a5 5 0 0 1-10 0c0-4 5-5 5-11z") {
        Ok(drop) => drop,
        Err(_) => panic!("not a path"),
    };
    const SEGMENTS: [PathSegment; DROP.len()] = DROP.to_array().unwrap();
    assert_eq!(SEGMENTS[..], DROP.iter().collect::<Vec<_>>());
    assert_eq!((SEGMENTS.len(), DROP.is_empty(), DROP.to_array::<3>(), DROP.to_array::<9>()), (6, false, None, None));
    assert!(Path::svg("").unwrap().is_empty());
}

/// A map goes before the rounding: 1/65,536 of a unit is seen.
#[test]
fn texts_are_mapped_before_they_are_rounded() {
    let mut rng = Rng::new(1_322);
    for _ in 0..cases(20_000) {
        let n: [i32; 6] = [(); 6].map(|()| rng.int(i32::MIN, i32::MAX) >> rng.int(0, 30));
        let [xx, xy, dx, yx, yy, dy] = n.map(I16F16::from_bits);
        let map = Affine { xx, xy, dx, yx, yy, dy };
        let at = [(); 2].map(|()| rng.range(-(1 << 39), (1 << 39) - 1) >> rng.int(0, 38));
        let [x, y] = at.map(|n| n as f64 / 65_536.0);
        let text = format!("M{x:.9} {y:.9}");
        let sum = |p: i32, q: i32, d: i32| {
            let wide = i128::from(p) * i128::from(at[0]) + i128::from(q) * i128::from(at[1]) + (i128::from(d) << 16);
            ((wide + (1 << 23)) >> 24).clamp(i32::MIN.into(), i32::MAX.into()) as i32
        };
        let wanted = PointFx::from_bits(sum(n[0], n[1], n[2]), sum(n[3], n[4], n[5]));
        assert!(Path::svg(&text).unwrap().mapped(map).eq([MoveTo(wanted)]), "{map:?} of {text}");
    }
}
