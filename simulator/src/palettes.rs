//! Colour tables as people have them, in files.
//!
//! | format | how a file begins | an entry |
//! |---|---|---|
//! | GIMP (`.gpl`) | `GIMP Palette` | `255 128 0 orange`; `#` begins a comment |
//! | JASC (`.pal`, Paint Shop Pro) | `JASC-PAL`, `0100`, the number of entries | `255 128 0` |
//! | hexadecimal (`.hex`, Lospec) | with an entry | `ff8000`, with or without `#` |
//! | Adobe colour table (`.act`) | with an entry: files of 768 or 772 bytes | three bytes; the last four bytes, if there are 772, begin with the number of entries |
//! ```
//! use embedded_graphics_core::pixelcolor::Rgb888;
//! use embedded_raster_simulator::palettes::{parse, to_rust};
//! let colors = parse(b"GIMP Palette\nName: Two\n#\n  0   0   0 ink\n255 128   0 orange\n")?;
//! assert_eq!(colors, [Rgb888::new(0, 0, 0), Rgb888::new(255, 128, 0)]);
//! assert_eq!(parse(b"000000\nff8000\n")?, colors);
//! println!("{}", to_rust("TWO", &colors));
//! # Ok::<(), embedded_raster_simulator::palettes::PaletteError>(())
//! ```

use std::{error::Error, fmt, fmt::Write as _, str};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

/// Why a file is no colour table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PaletteError {
    /// A line is no entry.
    NoEntry {
        /// Its number, from 1.
        line: usize,
        /// How it begins.
        text: String,
    },
    /// The file names another number of entries than it has.
    Entries {
        /// As it says.
        named: usize,
        /// As it has.
        found: usize,
    },
    /// More entries than an index of 8 bits reaches.
    TooMany {
        /// How many.
        found: usize,
    },
    /// No entries at all, or no text and not the length of an Adobe colour table.
    Empty,
}

impl fmt::Display for PaletteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoEntry { line, text } => write!(f, "line {line} is no colour: `{text}`"),
            Self::Entries { named, found } => write!(f, "the file names {named} colours and has {found}"),
            Self::TooMany { found } => write!(f, "{found} colours, and an index reaches 256"),
            Self::Empty => f.write_str("no colours: not a GIMP, JASC, hexadecimal or Adobe colour table"),
        }
    }
}

impl Error for PaletteError {}

/// How much of a line that is no entry an error repeats, in characters.
const MOST: usize = 24;

/// The colours of a file, 1 to 256. What kind it is shows in how it begins.
///
/// # Errors
///
/// See [`PaletteError`].
pub fn parse(file: &[u8]) -> Result<Vec<Rgb888>, PaletteError> {
    let text = str::from_utf8(file).ok().filter(|text| !text.contains('\0'));
    let text = text.map(|text| text.strip_prefix('\u{feff}').unwrap_or(text));
    let colors = match text {
        Some(text) if text.starts_with("GIMP Palette") => gimp(text)?,
        Some(text) if text.starts_with("JASC-PAL") => jasc(text)?,
        // A table of 256 greys is valid text of 768 bytes or near it: a line in hexadecimal tells.
        Some(text) if !is_act(file) || text.lines().next().and_then(hexadecimal).is_some() => hex(text)?,
        _ if is_act(file) => act(file)?,
        _ => return Err(PaletteError::Empty),
    };
    match colors.len() {
        0 => Err(PaletteError::Empty),
        1..=256 => Ok(colors),
        found => Err(PaletteError::TooMany { found }),
    }
}

/// A constant in Rust with these colours.
pub fn to_rust(name: &str, colors: &[Rgb888]) -> String {
    let mut text = format!("pub const {name}: Palette<Rgb888, {}> = Palette::new([\n", colors.len());
    for color in colors {
        writeln!(text, "    Rgb888::new({}, {}, {}),", color.r(), color.g(), color.b()).expect("to a string");
    }
    text.push_str("]);\n");
    text
}

fn is_act(file: &[u8]) -> bool {
    matches!(file.len(), 768 | 772)
}

fn no_entry(number: usize, text: &str) -> PaletteError {
    // The start of it, on one line whatever is in it.
    let start: String = text.trim_end().chars().take(MOST).flat_map(char::escape_debug).collect();
    let rest = if text.trim_end().chars().nth(MOST).is_some() { "..." } else { "" };
    PaletteError::NoEntry { line: number + 1, text: start + rest }
}

/// Three numbers at the start of a line, of 0 to 255.
fn decimal(line: &str) -> Option<Rgb888> {
    let mut words = line.split_whitespace().map(|word| word.parse().ok());
    Some(Rgb888::new(words.next()??, words.next()??, words.next()??))
}

fn hexadecimal(line: &str) -> Option<Rgb888> {
    let digits = line.trim().trim_start_matches('#');
    let is_rgb = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| is_rgb)?;
    let [blue, green, red, _] = number.to_le_bytes();
    Some(Rgb888::new(red, green, blue))
}

fn gimp(text: &str) -> Result<Vec<Rgb888>, PaletteError> {
    let is_header = |line: &str| ["Name:", "Columns:", "Channels:", "#"].iter().any(|word| line.starts_with(word));
    let entries =
        text.lines().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty() && !is_header(line.trim_start()));
    entries.map(|(number, line)| decimal(line).ok_or_else(|| no_entry(number, line))).collect()
}

fn jasc(text: &str) -> Result<Vec<Rgb888>, PaletteError> {
    // The name, the version, the number of entries.
    let mut lines = text.lines().enumerate().skip(2);
    let (number, line) = lines.next().ok_or(PaletteError::Empty)?;
    let named = line.trim().parse().map_err(|_| no_entry(number, line))?;
    let entries = lines.filter(|(_, line)| !line.trim().is_empty());
    let colors: Vec<_> =
        entries.map(|(number, line)| decimal(line).ok_or_else(|| no_entry(number, line))).collect::<Result<_, _>>()?;
    if colors.len() == named {
        Ok(colors)
    } else {
        Err(PaletteError::Entries { named, found: colors.len() })
    }
}

fn hex(text: &str) -> Result<Vec<Rgb888>, PaletteError> {
    let entries = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    entries.map(|(number, line)| hexadecimal(line).ok_or_else(|| no_entry(number, line))).collect()
}

fn act(file: &[u8]) -> Result<Vec<Rgb888>, PaletteError> {
    let (table, end) = file.split_at(768);
    let colors: Vec<_> = table.chunks_exact(3).map(|rgb| Rgb888::new(rgb[0], rgb[1], rgb[2])).collect();
    let named = end.first_chunk().map_or(256, |&count| u16::from_be_bytes(count).into());
    // Some programs write 0 where they mean all.
    match colors.get(..if named == 0 { 256 } else { named }) {
        Some(colors) => Ok(colors.to_vec()),
        None => Err(PaletteError::Entries { named, found: 256 }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const THREE: [Rgb888; 3] = [Rgb888::new(0, 0, 0), Rgb888::new(255, 128, 1), Rgb888::new(9, 20, 255)];

    #[test]
    fn every_format_gives_its_colors() {
        let gimp = "GIMP Palette\r\nName: Three\r\nColumns: 3\r\n# by nobody\r\n0 0 0\tblack\r\n255 128   1 Untitled\r\n  9  20 255\r\n";
        let jasc = "JASC-PAL\r\n0100\r\n3\r\n0 0 0\r\n255 128 1\r\n9 20 255\r\n";
        let aseprite = "GIMP Palette\nChannels: RGBA\n  # by nobody\n 0 0 0 255 a\n255 128 1 255 b\n9 20 255 255 c\n";
        for text in [
            gimp,
            jasc,
            aseprite,
            "\u{feff}000000\nFF8001\n0914ff",
            "000000\nFF8001\n0914ff",
            "#000000\r\n#ff8001\r\n#0914ff\r\n\r\n",
        ] {
            assert_eq!(parse(text.as_bytes()).as_deref(), Ok(&THREE[..]), "{text}");
        }
        let mut act = vec![0; 768];
        act[3..9].copy_from_slice(&[255, 128, 1, 9, 20, 255]);
        assert_eq!(parse(&act).map(|colors| colors.len()), Ok(256), "all of a short file");
        assert_eq!(parse(&[&act[..], &[0, 3, 0xff, 0xff]].concat()).as_deref(), Ok(&THREE[..]), "with their number");
        assert_eq!(parse(&[&act[..], &[0, 0, 0, 0]].concat()).map(|colors| colors.len()), Ok(256), "without it");
    }

    #[test]
    fn errors_carry_their_numbers() {
        let error = |text: &str| parse(text.as_bytes()).expect_err("no colour table").to_string();
        assert_eq!(error("GIMP Palette\n1 2 300\n"), "line 2 is no colour: `1 2 300`");
        assert_eq!(error("JASC-PAL\n0100\n2\n1 2 3\n"), "the file names 2 colours and has 1");
        assert_eq!(error("JASC-PAL\n0100\nmany\n"), "line 3 is no colour: `many`");
        assert_eq!(error("ff8000\nff80\n"), "line 2 is no colour: `ff80`");
        assert_eq!(
            error("ff8000\n\u{1b}[31m and more of it, for long"),
            "line 2 is no colour: `\\u{1b}[31m and more of it, fo...`"
        );
        assert_eq!(error(&"010203\n".repeat(257)), "257 colours, and an index reaches 256");
        assert_eq!(error(""), PaletteError::Empty.to_string());
        assert_eq!(parse(&[0xff; 700]), Err(PaletteError::Empty));
        assert_eq!(
            parse(&[&[0; 768][..], &[2, 0, 0, 0]].concat()),
            Err(PaletteError::Entries { named: 512, found: 256 })
        );
    }

    #[test]
    fn a_constant_is_what_a_program_has() {
        let text = to_rust("TWO", &THREE[..2]);
        assert_eq!(
            text,
            "pub const TWO: Palette<Rgb888, 2> = Palette::new([\n    Rgb888::new(0, 0, 0),\n    Rgb888::new(255, 128, 1),\n]);\n"
        );
    }
}
