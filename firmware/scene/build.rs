//! Turns the texts of the map and of the teapot into tables of numbers, which stay in flash.
//!
//! ```text
//!  POINTS     longitude, latitude      one after the other
//!  RINGS      points of each ring      the next ring starts where this one ends
//!  COUNTRIES  rings of each country    likewise
//!  LATITUDES  lowest, highest          of each country
//!
//!  PATCHES    16 places each, row by row, in 1/65536: y is up
//! ```

use std::{env, error::Error, fs, path::Path};

const MAP: &str = "../../assets/world-110m.txt";
const TEAPOT: &str = "../../assets/teapot-patches.txt";

fn main() -> Result<(), Box<dyn Error>> {
    map()?;
    teapot()
}

fn map() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed={MAP}");
    let (mut points, mut rings, mut countries) = (Vec::new(), Vec::new(), Vec::<usize>::new());
    let mut latitudes = Vec::new();
    for line in fs::read_to_string(MAP)?.lines() {
        if line.starts_with("country ") {
            countries.push(0);
            latitudes.push([i16::MAX, i16::MIN]);
        } else if let Some(ring) = line.strip_prefix("ring ") {
            let ring = ring.split_whitespace().map(point).collect::<Result<Vec<_>, _>>()?;
            rings.push(ring.len());
            let [low, high] = latitudes.last_mut().ok_or("a ring without a country")?;
            for &[_, latitude] in &ring {
                (*low, *high) = (latitude.min(*low), latitude.max(*high));
            }
            points.extend(ring);
            *countries.last_mut().ok_or("a ring without a country")? += 1;
        }
    }
    let text = format!(
        "static POINTS: [[i16; 2]; {}] = {points:?};\n\
         static RINGS: [u16; {}] = {rings:?};\n\
         static COUNTRIES: [u8; {}] = {countries:?};\n\
         static LATITUDES: [[i16; 2]; {}] = {latitudes:?};\n",
        points.len(),
        rings.len(),
        countries.len(),
        latitudes.len()
    );
    fs::write(Path::new(&env::var("OUT_DIR")?).join("world.rs"), text)?;
    Ok(())
}

fn point(text: &str) -> Result<[i16; 2], Box<dyn Error>> {
    let (x, y) = text.split_once(',').ok_or_else(|| format!("no point: {text}"))?;
    Ok([x.parse()?, y.parse()?])
}

fn teapot() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed={TEAPOT}");
    let (mut places, mut patches) = (Vec::<[i32; 3]>::new(), Vec::<[[[i32; 3]; 4]; 4]>::new());
    for line in fs::read_to_string(TEAPOT)?.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let ["v", x, y, z] = words[..] {
            let [x, y, z] = [bits(x)?, bits(y)?, bits(z)?];
            places.push([x, z, -y]);
        } else if let ["p", numbers @ ..] = &words[..] {
            let numbers = numbers.iter().map(|number| number.parse()).collect::<Result<Vec<usize>, _>>()?;
            if numbers.len() != 16 || numbers.iter().any(|&number| number == 0 || number > places.len()) {
                return Err(format!("no patch: {line}").into());
            }
            patches.push([0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| places[numbers[row + column] - 1])));
        }
    }
    let text = format!("static PATCHES: [[[[i32; 3]; 4]; 4]; {}] = {patches:?};\n", patches.len());
    fs::write(Path::new(&env::var("OUT_DIR")?).join("teapot.rs"), text)?;
    Ok(())
}

fn bits(text: &str) -> Result<i32, Box<dyn Error>> {
    Ok((text.parse::<f64>()? * 65_536.0).round() as i32)
}
