//! What can be chosen. Every choice has a name, which the page shows and links hold.

/// What is drawn.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Scene {
    /// All shapes on one page.
    Page,
    /// A cube with a spindle in it, with depth.
    Cube,
    /// Waves that are drawn once, and a palette that turns.
    Plasma,
    /// An oscilloscope: thousands of line segments.
    Scope,
    /// Text in bitmap fonts.
    Text,
    /// An analogue clock with soft rims.
    Clock,
}

/// What indices are shown through. From 16 bits on there are no indices.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Colors {
    /// Greys from black to white.
    Greys,
    /// The sixteen colours of the EGA.
    Ega,
    /// 216 colours, six levels of each channel.
    WebSafe,
    /// 256 colours: 3 bits of red and green, 2 of blue.
    Rgb332,
    /// The inks of e-paper: four at 2 bits, seven at 4.
    Inks,
    /// The palette that the scene brings along.
    Own,
}

/// How colours that there are not are shown.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Dither {
    /// By the nearest one.
    None,
    /// By thresholds in blocks of 2 x 2 pixels.
    Bayer2,
    /// By thresholds in blocks of 4 x 4 pixels.
    Bayer4,
    /// By thresholds in blocks of 8 x 8 pixels.
    Bayer8,
    /// By handing on what is wrong to the neighbours: it needs the picture in 24 bits, row by row.
    FloydSteinberg,
}

/// What the program draws on, and when the display shows it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Buffers {
    /// One buffer, which is shown while it is drawn.
    One,
    /// Two, exchanged as soon as a frame is finished, wherever the display is.
    TwoAtOnce,
    /// Two, exchanged when a refresh begins.
    Two,
    /// Three, so that the program never waits.
    Three,
}

/// Bits of a pixel.
pub const DEPTHS: [u8; 7] = [1, 2, 4, 8, 16, 24, 32];
/// Rows of a band; 0 for the whole screen.
pub const BANDS: [u16; 6] = [0, 120, 64, 32, 16, 8];
/// Milliseconds that the program takes for a frame. A refresh takes 16.7.
pub const TIMES: [u16; 3] = [4, 14, 24];

/// A choice of everything.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// What is drawn.
    pub scene: Scene,
    /// Bits of a pixel, of [`DEPTHS`].
    pub depth: u8,
    /// What indices are shown through.
    pub colors: Colors,
    /// How colours that there are not are shown.
    pub dither: Dither,
    /// What is drawn on.
    pub buffers: Buffers,
    /// Rows of a band, of [`BANDS`].
    pub band: u16,
    /// Milliseconds for a frame, of [`TIMES`].
    pub time: u16,
}

impl Choice {
    /// What is to be chosen, and the names of what there is, in the order of the numbers of [`from_numbers`](Self::from_numbers).
    pub const NAMES: [(&'static str, &'static [&'static str]); 7] = [
        ("scene", &["page", "cube", "plasma", "scope", "text", "clock"]),
        ("depth", &["1", "2", "4", "8", "16", "24", "32"]),
        ("colors", &["greys", "EGA", "web-safe", "RGB332", "e-paper", "own"]),
        ("dither", &["none", "Bayer-2", "Bayer-4", "Bayer-8", "Floyd-Steinberg"]),
        ("buffers", &["one", "two-at-once", "two", "three"]),
        ("band", &["whole", "120", "64", "32", "16", "8"]),
        ("time", &["4", "14", "24"]),
    ];

    /// The choice of these numbers, each counting the names of its kind from 0. `None` if there is no such name, or if the scene has no
    /// such palette at that depth. From 16 bits on any palette will do, as there is none.
    pub fn from_numbers([scene, depth, colors, dither, buffers, band, time]: [usize; 7]) -> Option<Self> {
        let choice = Self {
            scene: *Scene::ALL.get(scene)?,
            depth: *DEPTHS.get(depth)?,
            colors: *Colors::ALL.get(colors)?,
            dither: *Dither::ALL.get(dither)?,
            buffers: *Buffers::ALL.get(buffers)?,
            band: *BANDS.get(band)?,
            time: *TIMES.get(time)?,
        };
        choice.colors.exist(choice.scene, choice.depth).then_some(choice)
    }

    /// Two of each scene, as numbers: all depths, dithers and ways of buffering are among them. For chips, on which an emulator takes a while.
    pub fn on_chips() -> impl Iterator<Item = [usize; 7]> {
        (0..12).map(|n| {
            let (scene, depth) = (n % 6, n * 3 % 7);
            let exists = |&colors: &usize| Self::from_numbers([scene, depth, colors, 0, 0, 0, 0]).is_some();
            // The last palette that there is, and from 16 bits on the first name.
            let colors = if depth < 4 { (0..Colors::ALL.len()).rev().find(exists) } else { None };
            [scene, depth, colors.unwrap_or(0), n % 5, n % 4, n * 5 % 6, n % 3]
        })
    }

    /// What the browser is compared with, as numbers: all pairs of looks with all scenes, whole; and all ways of buffering and all bands with all scenes
    /// and depths. As numbers.
    pub fn checked() -> impl Iterator<Item = [usize; 7]> {
        let lens = Self::NAMES.map(|(_, names)| names.len());
        let looks = product([lens[0], lens[1], lens[2], lens[3]]).map(|[s, d, c, i]| [s, d, c, i, 2, 0, 1]);
        let ways = product([lens[0], lens[1], lens[4], lens[5]]).map(move |[s, d, b, r]| {
            // The first palette that there is, and all dithers and times in turn.
            let turn = s + d + b + r;
            let colors = (0..lens[2]).find(|&c| Self::from_numbers([s, d, c, 0, 0, 0, 0]).is_some()).unwrap_or(0);
            [s, d, colors, turn % lens[3], b, r, turn % lens[6]]
        });
        // Without a palette one name of it is enough.
        let is_one = |[_, depth, colors, ..]: &[usize; 7]| DEPTHS[*depth] <= 8 || *colors == 0;
        looks.chain(ways).filter(is_one).filter(|&numbers| Self::from_numbers(numbers).is_some())
    }
}

/// All numbers below some others, side by side.
fn product([a, b, c, d]: [usize; 4]) -> impl Iterator<Item = [usize; 4]> {
    (0..a * b * c * d).map(move |n| [n / d / c / b, n / d / c % b, n / d % c, n % d])
}

impl Scene {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Page, Self::Cube, Self::Plasma, Self::Scope, Self::Text, Self::Clock];
}

impl Colors {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Greys, Self::Ega, Self::WebSafe, Self::Rgb332, Self::Inks, Self::Own];

    /// Whether a scene can be shown in these at a depth.
    pub fn exist(self, scene: Scene, depth: u8) -> bool {
        match self {
            _ if depth > 8 => true,
            Self::Greys => true,
            Self::Ega => depth == 4,
            Self::WebSafe | Self::Rgb332 => depth == 8,
            Self::Inks => depth == 2 || depth == 4,
            Self::Own => match scene {
                Scene::Cube => false,
                Scene::Plasma => depth == 8,
                Scene::Scope => depth >= 2,
                Scene::Page | Scene::Text | Scene::Clock => depth >= 4,
            },
        }
    }
}

impl Dither {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::None, Self::Bayer2, Self::Bayer4, Self::Bayer8, Self::FloydSteinberg];
}

impl Buffers {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::One, Self::TwoAtOnce, Self::Two, Self::Three];

    /// How many there are.
    pub fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::TwoAtOnce | Self::Two => 2,
            Self::Three => 3,
        }
    }

    /// Whether frames are exchanged when a refresh begins, and only then.
    pub fn wait(self) -> bool {
        matches!(self, Self::Two | Self::Three)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_choice() {
        for (kind, (name, names)) in Choice::NAMES.iter().enumerate() {
            let with = |number| {
                // At 24 bits there is every palette.
                let mut numbers = [0, 5, 0, 0, 0, 0, 0];
                numbers[kind] = number;
                Choice::from_numbers(numbers)
            };
            // One bit has greys.
            assert!((0..names.len()).all(|number| with(number).is_some()), "{name}");
            assert!(with(names.len()).is_none(), "{name}");
        }
        assert_eq!(Choice::from_numbers([1, 2, 5, 0, 0, 0, 0]), None, "a cube has no palette of its own");
        for ([kind, names], numbers) in [
            (["depth", "1 2 4 8 16 24 32"], DEPTHS.map(u16::from).as_slice()),
            (["band", "whole 120 64 32 16 8"], &BANDS),
            (["time", "4 14 24"], &TIMES),
        ] {
            let (_, known) = Choice::NAMES.iter().find(|(name, _)| *name == kind).expect("a kind");
            assert!(names.split(' ').eq(known.iter().copied()), "{kind}");
            let read = known.iter().map(|name| name.parse().unwrap_or(0));
            assert!(read.eq(numbers.iter().copied()), "{kind}");
        }
    }

    #[test]
    fn what_is_checked_has_every_name() {
        let mut seen = [[false; 7]; 7];
        for numbers in Choice::checked() {
            assert!(Choice::from_numbers(numbers).is_some(), "{numbers:?}");
            for (seen, number) in seen.iter_mut().zip(numbers) {
                seen[number] = true;
            }
        }
        for (seen, (name, names)) in seen.iter().zip(Choice::NAMES) {
            assert!(seen[..names.len()].iter().all(|&seen| seen), "{name}");
        }
    }

    #[test]
    fn chips_play_every_name_but_of_palettes() {
        let mut seen = [[false; 7]; 7];
        for numbers in Choice::on_chips() {
            assert!(Choice::from_numbers(numbers).is_some(), "{numbers:?}");
            for (seen, number) in seen.iter_mut().zip(numbers) {
                seen[number] = true;
            }
        }
        for (seen, (name, names)) in seen.iter().zip(Choice::NAMES) {
            assert!(name == "colors" || seen[..names.len()].iter().all(|&seen| seen), "{name}");
        }
    }
}
