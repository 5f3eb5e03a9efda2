//! Turns the map's text into tables of 16-bit numbers, which stay in flash.
//!
//! ```text
//!  POINTS     longitude, latitude      one after the other
//!  RINGS      points of each ring      the next ring starts where this one ends
//!  COUNTRIES  rings of each country    likewise
//! ```

use std::{env, error::Error, fs, path::Path};

const MAP: &str = "../../assets/world-110m.txt";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed={MAP}");
    let (mut points, mut rings, mut countries) = (Vec::new(), Vec::new(), Vec::<usize>::new());
    for line in fs::read_to_string(MAP)?.lines() {
        if line.starts_with("country ") {
            countries.push(0);
        } else if let Some(ring) = line.strip_prefix("ring ") {
            let ring = ring.split_whitespace().map(point).collect::<Result<Vec<_>, _>>()?;
            rings.push(ring.len());
            points.extend(ring);
            *countries.last_mut().ok_or("a ring without a country")? += 1;
        }
    }
    let text = format!(
        "static POINTS: [[i16; 2]; {}] = {points:?};\n\
         static RINGS: [u16; {}] = {rings:?};\n\
         static COUNTRIES: [u8; {}] = {countries:?};\n",
        points.len(),
        rings.len(),
        countries.len()
    );
    fs::write(Path::new(&env::var("OUT_DIR")?).join("world.rs"), text)?;
    Ok(())
}

fn point(text: &str) -> Result<[i16; 2], Box<dyn Error>> {
    let (x, y) = text.split_once(',').ok_or_else(|| format!("no point: {text}"))?;
    Ok([x.parse()?, y.parse()?])
}
