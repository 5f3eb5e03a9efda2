//! [`Map`]: countries as rings of places, and who their neighbours are.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt, str,
};

/// A place on the globe, in hundredths of a degree.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Longitude, east of Greenwich: -18,000 to 18,000.
    pub lon: i32,
    /// Latitude, north of the equator: -9,000 to 9,000.
    pub lat: i32,
}

/// A country: one ring for each of its islands, and one for each hole in them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Country {
    /// Its name.
    pub name: String,
    /// Closed contours, the last place joined to the first.
    pub rings: Vec<Vec<Place>>,
}

/// The countries of a map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    /// In the order of the file.
    pub countries: Vec<Country>,
}

/// A side of some ring, once however many countries have it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Border {
    /// Its ends, the lower one first.
    pub ends: [Place; 2],
    /// Whether sea is on its other side.
    pub is_coast: bool,
}

/// What is wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// The line, from 1 on.
    pub line: usize,
    /// The trouble with it.
    pub problem: String,
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.problem)
    }
}

impl std::error::Error for ParseError {}

impl Map {
    /// Reads a map from text: `country NAME`, then a line `ring X,Y X,Y X,Y ...` for each contour, in hundredths of a
    /// degree of longitude and latitude. Empty lines and lines that start with `#` say nothing.
    ///
    /// # Errors
    /// The first line that is none of these, and a text without countries.
    /// ```
    /// use embedded_raster_simulator::world::Map;
    /// let map = Map::parse(b"country Null Island\nring -50,-50 50,-50 0,50\n")?;
    /// assert_eq!(map.countries[0].rings[0].len(), 3);
    /// let error = Map::parse(b"country Null Island\nring -50,-50 50,-5O 0,50\n").unwrap_err();
    /// assert_eq!(error.to_string(), "line 2: `50,-5O` is not a place: two whole numbers X,Y");
    /// # Ok::<(), embedded_raster_simulator::world::ParseError>(())
    /// ```
    pub fn parse(text: &[u8]) -> Result<Self, ParseError> {
        let mut countries = Vec::new();
        let mut lines = 0;
        for (line, bytes) in (1..).zip(text.split(|&byte| byte == b'\n')) {
            lines = line;
            parse_line(bytes, &mut countries).map_err(|problem| ParseError { line, problem })?;
        }
        if countries.is_empty() {
            return Err(ParseError { line: lines, problem: "the map ends without a country".into() });
        }
        Ok(Self { countries })
    }

    /// The sides of all rings, each once.
    pub fn borders(&self) -> Vec<Border> {
        let mut users = BTreeMap::<[Place; 2], u32>::new();
        for (_, mut ends) in self.sides() {
            ends.sort_unstable();
            *users.entry(ends).or_default() += 1;
        }
        users.into_iter().map(|(ends, users)| Border { ends, is_coast: users == 1 }).collect()
    }

    /// For each country, those that share a place of their borders with it.
    pub fn neighbours(&self) -> Vec<BTreeSet<usize>> {
        let mut users = BTreeMap::<Place, BTreeSet<usize>>::new();
        for (country, [place, _]) in self.sides() {
            users.entry(place).or_default().insert(country);
        }
        let mut neighbours = vec![BTreeSet::new(); self.countries.len()];
        for countries in users.values() {
            for &country in countries {
                neighbours[country].extend(countries.iter().filter(|&&other| other != country));
            }
        }
        neighbours
    }

    /// A colour below `colors` for each country, such that neighbours differ; the same for the same map.
    ///
    /// Countries are set aside one by one, always one with the fewest neighbours left, and coloured in the reverse order
    /// with the rarest colour that no neighbour has. In a planar map somebody always has at most five neighbours left, so
    /// six colours are enough; where they are not, the rarest colour of all is taken.
    ///
    /// Source: D. W. Matula and L. L. Beck, "Smallest-last ordering and clustering and graph coloring algorithms", Journal
    /// of the ACM 30(3), 1983.
    ///
    /// # Panics
    /// If `colors` is 0.
    pub fn colors(&self, colors: usize) -> Vec<usize> {
        let neighbours = self.neighbours();
        let mut left: BTreeSet<usize> = (0..neighbours.len()).collect();
        let mut order = Vec::new();
        while let Some(&next) = left.iter().min_by_key(|&&country| neighbours[country].intersection(&left).count()) {
            left.remove(&next);
            order.push(next);
        }
        let mut chosen = vec![None; neighbours.len()];
        let mut uses = vec![0; colors];
        for &country in order.iter().rev() {
            let taken = |color: usize| neighbours[country].iter().any(|&other| chosen[other] == Some(color));
            let color = (0..colors).min_by_key(|&color| (taken(color), uses[color])).expect("there are colours");
            chosen[country] = Some(color);
            uses[color] += 1;
        }
        chosen.into_iter().flatten().collect()
    }

    /// Every side of every ring, with the number of its country.
    fn sides(&self) -> impl Iterator<Item = (usize, [Place; 2])> + '_ {
        let rings =
            self.countries.iter().enumerate().flat_map(|(i, country)| country.rings.iter().map(move |r| (i, r)));
        rings.flat_map(|(i, ring)| ring.iter().zip(ring.iter().cycle().skip(1)).map(move |(&a, &b)| (i, [a, b])))
    }
}

/// Takes one line in, or says what is wrong with it.
fn parse_line(line: &[u8], countries: &mut Vec<Country>) -> Result<(), String> {
    let line = str::from_utf8(line).map_err(|_| "not UTF-8")?.trim();
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    match word {
        "country" if rest.is_empty() => Err("a country without a name".into()),
        "country" => {
            countries.push(Country { name: rest.trim().to_owned(), rings: Vec::new() });
            Ok(())
        }
        "ring" => {
            let ring = rest.split_whitespace().map(parse_place).collect::<Result<Vec<_>, _>>()?;
            if ring.len() < 3 {
                return Err(format!("a ring of {} places: it takes at least 3", ring.len()));
            }
            countries.last_mut().ok_or("a ring before the first country")?.rings.push(ring);
            Ok(())
        }
        _ if line.is_empty() || line.starts_with('#') => Ok(()),
        _ => Err(format!("`{}` is neither `country` nor `ring`", shortened(word))),
    }
}

fn parse_place(text: &str) -> Result<Place, String> {
    let numbers = text.split_once(',').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
    match numbers {
        None => Err(format!("`{}` is not a place: two whole numbers X,Y", shortened(text))),
        Some((lon @ -18_000..=18_000, lat @ -9_000..=9_000)) => Ok(Place { lon, lat }),
        Some((x, y)) => Err(format!("{x},{y} is beyond +-18000,+-9000 hundredths of a degree")),
    }
}

/// Enough of a word to find it by.
fn shortened(word: &str) -> String {
    word.chars().take(40).flat_map(char::escape_debug).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHIPPED: &[u8] = include_bytes!("../../../assets/world-110m.txt");

    #[test]
    fn a_malformed_line_is_named() {
        for (text, expected) in [
            (&b""[..], "line 1: the map ends without a country"),
            (b"# nobody\n\n", "line 3: the map ends without a country"),
            (b"country\n", "line 1: a country without a name"),
            (b"ring 0,0 1,0 0,1", "line 1: a ring before the first country"),
            (b"country A\nring 0,0 1,0", "line 2: a ring of 2 places: it takes at least 3"),
            (b"country A\r\n\r\nring 0,0 1,0 7", "line 3: `7` is not a place: two whole numbers X,Y"),
            (b"country A\nring 0,0 1,0 0,1.5", "line 2: `0,1.5` is not a place: two whole numbers X,Y"),
            (b"country A\nring 0,0 1,0 0,99999999999", "line 2: `0,99999999999` is not a place: two whole numbers X,Y"),
            (b"country A\nring 0,0 1,0 0,9001", "line 2: 0,9001 is beyond +-18000,+-9000 hundredths of a degree"),
            (b"country A\nisland 0,0", "line 2: `island` is neither `country` nor `ring`"),
            (b"country A\ncountry \xff", "line 2: not UTF-8"),
        ] {
            let found = Map::parse(text).map_err(|error| error.to_string());
            assert_eq!(found, Err(expected.to_owned()), "{}", String::from_utf8_lossy(text));
        }
    }

    #[test]
    fn names_keep_their_spaces() {
        let map = Map::parse(b"\tcountry  Trinidad and Tobago \r\n").expect("well-formed");
        assert_eq!(map.countries, [Country { name: "Trinidad and Tobago".into(), rings: vec![] }], "a name");
    }

    #[test]
    fn the_shipped_map_is_whole() {
        let map = Map::parse(SHIPPED).expect("well-formed");
        assert_eq!(map.countries.len(), 177, "countries");
        assert_eq!(map.countries.iter().map(|country| country.rings.len()).sum::<usize>(), 288, "rings");
        let borders = map.borders();
        assert_eq!(borders.iter().filter(|border| border.is_coast).count(), 5008, "sides on the sea");
        assert_eq!(borders.len(), 5008 + 2648, "sides");
    }

    #[test]
    fn neighbours_never_share_a_color() {
        let map = Map::parse(SHIPPED).expect("well-formed");
        let (neighbours, colors) = (map.neighbours(), map.colors(6));
        for (country, others) in neighbours.iter().enumerate() {
            for &other in others {
                assert_ne!(colors[country], colors[other], "{country} and {other}");
            }
        }
        let uses = |color| colors.iter().filter(|&&c| c == color).count();
        assert!((0..6).all(|color| uses(color) >= 177 / 6 - 3), "evenly used: {:?}", (0..6).map(uses));
        let number = |name| map.countries.iter().position(|country| country.name == name).expect("it is there");
        assert_eq!(neighbours[number("Lesotho")], BTreeSet::from([number("South Africa")]), "an enclave");
    }
}
