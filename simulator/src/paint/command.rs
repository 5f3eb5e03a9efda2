//! [`Command`], and scripts of them: a command a line, numbers between blanks.

use std::{fmt, ops::RangeInclusive, str::FromStr};

use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb888};

/// One thing to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Command {
    /// Takes a new sheet of this size, of colour 0.
    Size(u16, u16),
    /// Takes a new sheet of this depth, of colour 0, with the standard palette of the depth. The number of the colour to paint with
    /// is cut to as many bits.
    Bits(u8),
    /// Paints the whole sheet.
    Clear,
    /// Chooses the colour to paint with. One beyond the depth is an error.
    Color(u8),
    /// Whether ellipses, rectangles and polygons are filled from now on.
    Filled(bool),
    /// Joins pixels.
    Pencil(Vec<Point>),
    /// Joins two pixels.
    Line([Point; 2]),
    /// An ellipse between two corners of its box.
    Ellipse([Point; 2]),
    /// A rectangle between two corners.
    Rectangle([Point; 2]),
    /// A polygon of at least three corners.
    Polygon(Vec<Point>),
    /// Fills what has one colour and is connected by sides.
    Fill(Point),
    /// Changes an entry of the palette, and takes back all cycling. An entry beyond the depth is an error.
    Palette(u8, Rgb888),
    /// The entries that cycle, both ends included. It may reach beyond the depth: what is not there does not cycle.
    Range(u8, u8),
    /// Moves the colours of the range up by so many places, or down. The sheet keeps its palette: see `Paint`.
    Cycle(i32),
    /// Scratch memory: slots for flood fills, edges for polygons.
    Scratch(usize, usize),
    /// Goes a step back.
    Undo,
    /// Takes the last undo back.
    Redo,
    /// Writes an indexed PNG.
    Save(String),
}

/// How each command is written in a script. The first word is its name.
pub const FORMS: [&str; 19] = [
    "size WIDTH HEIGHT",
    "bits 1|2|4|8",
    "clear",
    "color INDEX",
    "filled",
    "outline",
    "pencil X Y [X Y ...]",
    "line X Y X Y",
    "ellipse X Y X Y",
    "rectangle X Y X Y",
    "polygon X Y X Y X Y [X Y ...]",
    "fill X Y",
    "palette INDEX R G B",
    "range FIRST LAST",
    "cycle STEPS",
    "scratch SLOTS EDGES",
    "undo",
    "redo",
    "save FILE",
];

/// The largest side of a sheet, and the largest scratch table.
const LARGEST: u16 = 1024;

/// What is wrong with a script, or went wrong when it ran.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScriptError {
    /// The line, from 1 on.
    pub line: usize,
    /// The trouble with it, and what was expected.
    pub problem: String,
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.problem)
    }
}

impl std::error::Error for ScriptError {}

/// Reads a script: commands with the numbers of their lines. Empty lines, and what follows a `#` between blanks, say nothing.
///
/// # Errors
/// The first line that is no command.
/// ```
/// use embedded_raster_simulator::paint::{parse, Command};
/// assert_eq!(parse("# sky\n color 9\n")?, [(2, Command::Color(9))]);
/// let error = parse("\nfill 7 1O").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: `1O` is no whole number; expected `fill X Y`");
/// # Ok::<(), embedded_raster_simulator::paint::ScriptError>(())
/// ```
pub fn parse(script: &str) -> Result<Vec<(usize, Command)>, ScriptError> {
    let commands = (1..).zip(script.lines()).filter_map(|(line, text)| {
        let words: Vec<_> = text.split_whitespace().take_while(|word| !word.starts_with('#')).collect();
        let (&name, rest) = words.split_first()?;
        let command = one(name, &Words(rest)).map(|command| (line, command));
        Some(command.map_err(|problem| ScriptError { line, problem }))
    });
    commands.collect()
}

fn one(name: &str, words: &Words<'_>) -> Result<Command, String> {
    let names = FORMS.map(|form| form.split(' ').next().unwrap_or(form));
    let Some(at) = names.iter().position(|&known| known == name) else {
        return Err(format!("no command `{name}`; expected one of {}", names.join(", ")));
    };
    command(name, words).map_err(|problem| format!("{problem}; expected `{}`", FORMS[at]))
}

fn command(name: &str, words: &Words<'_>) -> Result<Command, String> {
    let sides = 1..=LARGEST;
    let slots = 0..=usize::from(LARGEST);
    Ok(match name {
        "size" => words.numbers(sides).map(|[width, height]| Command::Size(width, height))?,
        "bits" => match words.numbers(1..=8)? {
            [bits @ (1 | 2 | 4 | 8)] => Command::Bits(bits),
            [bits] => return Err(format!("there are no {bits} bits")),
        },
        "clear" => words.none(Command::Clear)?,
        "color" => words.numbers(0..=255).map(|[index]| Command::Color(index))?,
        "filled" => words.none(Command::Filled(true))?,
        "outline" => words.none(Command::Filled(false))?,
        "pencil" => Command::Pencil(words.points(1)?),
        "line" => Command::Line(words.two_points()?),
        "ellipse" => Command::Ellipse(words.two_points()?),
        "rectangle" => Command::Rectangle(words.two_points()?),
        "polygon" => Command::Polygon(words.points(3)?),
        "fill" => words.numbers(ANY).map(|[x, y]| Command::Fill(Point::new(x, y)))?,
        "palette" => words.numbers(0..=255).map(|[index, r, g, b]| Command::Palette(index, Rgb888::new(r, g, b)))?,
        "range" => match words.numbers(0..=255)? {
            [first, last] if first <= last => Command::Range(first, last),
            [first, last] => return Err(format!("{first} comes after {last}")),
        },
        "cycle" => words.numbers(ANY).map(|[steps]| Command::Cycle(steps))?,
        "scratch" => words.numbers(slots).map(|[slots, edges]| Command::Scratch(slots, edges))?,
        "undo" => words.none(Command::Undo)?,
        "redo" => words.none(Command::Redo)?,
        _ if words.0.is_empty() => return Err("the name of the file is missing".into()),
        _ => Command::Save(words.0.join(" ")),
    })
}

const ANY: RangeInclusive<i32> = i32::MIN..=i32::MAX;

/// What follows the name.
struct Words<'a>(&'a [&'a str]);

impl Words<'_> {
    fn none(&self, command: Command) -> Result<Command, String> {
        self.numbers(ANY).map(|[]| command)
    }

    /// Exactly `N` numbers of a range.
    fn numbers<const N: usize, T>(&self, range: RangeInclusive<T>) -> Result<[T; N], String>
    where
        T: FromStr + Copy + PartialOrd + fmt::Display,
    {
        let numbers = self.0.iter().map(|word| number(word, &range)).collect::<Result<Vec<_>, _>>()?;
        numbers.try_into().map_err(|_| format!("{} numbers instead of {N}", self.0.len()))
    }

    fn two_points(&self) -> Result<[Point; 2], String> {
        self.numbers(ANY).map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)])
    }

    /// At least so many points.
    fn points(&self, least: usize) -> Result<Vec<Point>, String> {
        let numbers = self.0.iter().map(|word| number(word, &ANY)).collect::<Result<Vec<_>, _>>()?;
        if numbers.len() % 2 != 0 || numbers.len() < 2 * least {
            return Err(format!("{} numbers instead of at least {least} pairs", numbers.len()));
        }
        Ok(numbers.chunks_exact(2).map(|pair| Point::new(pair[0], pair[1])).collect())
    }
}

fn number<T: FromStr + PartialOrd + fmt::Display>(word: &str, range: &RangeInclusive<T>) -> Result<T, String> {
    // "Too large" and "no number" are different troubles: digits are a number, however many there are.
    let digits = word.strip_prefix(['+', '-']).unwrap_or(word);
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return Err(format!("`{word}` is no whole number"));
    }
    let inside = word.parse().ok().filter(|number| range.contains(number));
    inside.ok_or_else(|| format!("{word} is not in {} to {}", range.start(), range.end()))
}
