//! The playground: a page in the browser that plays the scenes, built as one folder of files. Its pictures are those of this computer:
//! [`check`] compares them in a browser without a window.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{ensure, Context, Result};
use base64::prelude::{Engine, BASE64_STANDARD};
use serde_json::{json, Value};

use crate::browser::{Browser, Page};
use crate::firmware::{project, Build, Program};
use crate::toolchain::Toolchain;
use crate::{run, scene, server};

const TARGET: &str = "wasm32-unknown-unknown";

/// Files of the page that are written by hand.
const FILES: [&str; 3] = ["index.html", "main.js", "style.css"];

/// The scenes, and what is shown as the source of each.
const SOURCES: [(&str, &str); 6] = [
    ("page", "examples/shapes/page.rs"),
    ("cube", "examples/cube/scene.rs"),
    ("plasma", "examples/plasma/scene.rs"),
    ("scope", "examples/scope/scene.rs"),
    ("text", "examples/text/scene.rs"),
    ("clock", "simulator/src/clock/face.rs"),
];

/// Choices that a browser plays between two messages.
const AT_ONCE: usize = 40;

/// Builds the page and returns its folder.
pub fn build() -> Result<PathBuf> {
    let (folder, wasm) = (project().join("target/playground"), fs::read(build_wasm()?)?);
    fs::create_dir_all(&folder)?;
    for file in FILES {
        fs::copy(project().join("playground/page").join(file), folder.join(file)).context(file)?;
    }
    fs::write(folder.join("playground.wasm"), &wasm)?;
    // A page that is opened from a folder may run scripts, and fetch nothing.
    fs::write(folder.join("wasm.js"), format!("const WASM = \"{}\";\n", BASE64_STANDARD.encode(&wasm)))?;
    fs::write(folder.join("sources.js"), format!("const SOURCES = {};\n", sources()?))?;
    Ok(folder)
}

/// Builds the page, and serves it until it is stopped.
pub fn serve() -> Result<()> {
    println!("{}", server::serve(&build()?, 8000)?);
    loop {
        std::thread::park();
    }
}

/// Compares what the browser shows with this computer, choice by choice; and looks whether the page works from a folder, by keys, and on
/// a narrow screen. Passes where no browser is installed, and says so.
pub fn check() -> Result<()> {
    let Some(program) = Browser::find() else {
        println!("skipped: no browser is installed. On Debian: apt-get install --no-install-recommends chromium");
        return Ok(());
    };
    let (folder, expected) = (build()?, on_host(&[])?);
    let wasm = fs::metadata(folder.join("playground.wasm"))?.len();
    let address = server::serve(&folder, 0)?;
    let profile = project().join(format!("target/browser-{}", std::process::id()));
    let mut browser = Browser::start(&program, &profile)?;

    let mut page = browser.open(&format!("{address}index.html"))?;
    wait_for_start(&mut page)?;
    compare(&mut page, &expected)?;
    println!("{} choices: the memory and the picture in the browser are those of this computer", expected.len());
    let chips = compare_chips(&mut page)?;
    println!("{chips} frames of the firmwares: those of this computer");
    let (pressed, link) = by_keys(&mut page)?;
    println!("{pressed} choices by keys alone: {link}");
    for (name, width, height) in [("narrow", 360, 740), ("wide", 1280, 900)] {
        let path = folder.join(format!("{name}.png"));
        fits(&mut page, width, height, &expected[expected.len() / 2])?;
        // What it costs is written down when a button is pressed.
        page.evaluate("document.getElementById('step').click()")?;
        page.photograph(&path)?;
        println!("{width} pixels wide: {}", path.display());
    }
    from_folder(&mut browser, &folder, &expected[0])?;
    println!("opened from its folder: the same. {wasm} bytes of WebAssembly");
    Ok(())
}

/// Plays some choices on chips, in some builds, and fails where one is not what this computer plays.
pub fn check_chips(builds: &[Build]) -> Result<()> {
    for &build in builds {
        let output = run(&Program { package: "player", bin: "player" }, build)?;
        let played = output.lines().map(parse).collect::<Result<Vec<_>>>()?;
        let links: Vec<&str> = played.iter().map(|played| played.link.as_str()).collect();
        let host = on_host(&links)?;
        ensure!(host.len() == played.len(), "{build} plays {} choices, this computer {}", played.len(), host.len());
        for (Played { link, sums }, host) in played.iter().zip(&host) {
            ensure!(*sums == host.sums, "{link}: {sums:?} on {build}, on this computer {:?}", host.sums);
        }
        println!("{build}: {} choices of the playground, as on this computer", played.len());
    }
    Ok(())
}

/// Builds the player for browsers, and returns its file.
fn build_wasm() -> Result<PathBuf> {
    let mut cargo = Toolchain::find_for(TARGET)?.cargo_build_for([TARGET]);
    let (door, target_dir) = (project().join("playground/door"), project().join("target/door"));
    cargo.args(["--quiet", "--release", "--target-dir"]).arg(&target_dir).current_dir(door);
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(status.success(), "the playground does not build: cargo ended with {status}");
    Ok(target_dir.join(TARGET).join("release/door.wasm"))
}

/// The sources of the scenes as an object of JavaScript.
fn sources() -> Result<Value> {
    let mut all = json!({});
    for (scene, file) in SOURCES {
        let text = fs::read_to_string(project().join(file)).context(file)?;
        all[scene] = json!({ "file": file, "text": text });
    }
    Ok(all)
}

/// A choice that was played.
struct Played {
    /// What links call it.
    link: String,
    /// The checksums of the memory and of the picture.
    sums: [String; 2],
}

/// Plays on this computer: what some links say, or all that is to be compared.
fn on_host(links: &[&str]) -> Result<Vec<Played>> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["run", "--quiet", "--release", "--package", "playground", "--example", "host", "--"]).args(links);
    let output = cargo.current_dir(project()).output().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(output.status.success(), "playing on this computer: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout)?.lines().map(parse).collect()
}

fn parse(line: &str) -> Result<Played> {
    let fields: Vec<&str> = line.split(';').collect();
    let &[link, memory, picture] = &fields[..] else { anyhow::bail!("not three fields: `{line}`") };
    Ok(Played { link: link.into(), sums: [memory.into(), picture.into()] })
}

fn wait_for_start(page: &mut Page<'_>) -> Result<()> {
    page.wait_for("typeof playground === 'object'")
}

/// What the page shows of some links, one after the other.
fn played_in(page: &mut Page<'_>, links: &[&str]) -> Result<Vec<[String; 2]>> {
    let expression = format!(
        "{}.map((link) => {{ playground.open(link); return [playground.memoryCrc(), playground.pictureCrc()]; }})",
        json!(links)
    );
    Ok(serde_json::from_value(page.evaluate(&expression)?)?)
}

fn compare(page: &mut Page<'_>, expected: &[Played]) -> Result<()> {
    for some in expected.chunks(AT_ONCE) {
        let links: Vec<&str> = some.iter().map(|played| played.link.as_str()).collect();
        let seen = played_in(page, &links)?;
        ensure!(seen.len() == some.len(), "{} choices instead of {}", seen.len(), some.len());
        for (Played { link, sums }, seen) in some.iter().zip(seen) {
            ensure!(*sums == seen, "{link}: memory and picture have the checksums {seen:?}, on this computer {sums:?}");
        }
    }
    Ok(())
}

/// Compares the frames of the firmwares, which `cargo xtask scene` compares with chips. Returns how many there are.
fn compare_chips(page: &mut Page<'_>) -> Result<usize> {
    let mut expected = Vec::new();
    for example in ["host", "cube", "moving"] {
        expected.extend(scene::on_host(example)?);
    }
    let sums =
        "Array.from({ length: playground.player.chip_frames() }, (_, n) => playground.player.chip_crc32(n) >>> 0)";
    let seen: Vec<u32> = serde_json::from_value(page.evaluate(sums)?)?;
    ensure!(seen.len() == expected.len(), "{} frames in the browser, {} on this computer", seen.len(), expected.len());
    for (frame, seen) in expected.iter().zip(seen) {
        let (name, sum) = (&frame.name, frame.crc32);
        ensure!(sum == seen, "{name} has the checksum {seen:08x} in the browser, {sum:08x} on this computer");
    }
    Ok(expected.len())
}

/// Goes through all choices by keys, takes the next one of each, and stops the display by the space bar; then looks whether the picture is what
/// this computer plays of that choice. Returns how many choices were made, and what they are.
fn by_keys(page: &mut Page<'_>) -> Result<(usize, String)> {
    const TAB: u32 = 9;
    const DOWN: u32 = 40;
    const SPACE: u32 = 32;
    page.resize(1280, 900)?;
    page.evaluate("playground.open('scene=page&depth=2&colors=greys'); document.activeElement.blur()")?;
    let (mut pressed, mut seen) = (0, Vec::new());
    // As many as there are elements that keys reach, and some.
    for _ in 0..20 {
        page.press("Tab", TAB)?;
        let id = page.evaluate("document.activeElement.id")?;
        let id = id.as_str().unwrap_or_default().to_owned();
        if seen.contains(&id) {
            continue;
        }
        if page.evaluate("document.activeElement.tagName")? == "SELECT" {
            let value = "document.activeElement.value";
            let before = page.evaluate(value)?;
            page.press("ArrowDown", DOWN)?;
            ensure!(page.evaluate(value)? != before, "the arrow changes nothing of `{id}`");
            pressed += 1;
        }
        seen.push(id);
    }
    ensure!(pressed == 7, "keys reach {pressed} of 7 choices: {seen:?}");
    // Play, and stop.
    page.evaluate("document.getElementById('play').focus()")?;
    let playing = "document.getElementById('state').textContent.startsWith('playing')";
    for wanted in [true, false] {
        if page.evaluate(playing)? != wanted {
            page.press(" ", SPACE)?;
        }
        ensure!(page.evaluate(playing)? == wanted, "the space bar does not press the button");
    }
    let link = page.evaluate("document.getElementById('link').getAttribute('href').slice(1)")?;
    let link = link.as_str().context("no link")?.to_owned();
    let host = on_host(&[&link])?;
    let now = page.evaluate("[playground.memoryCrc(), playground.pictureCrc()]")?;
    let host = host.first().context("no answer")?;
    ensure!(now == json!(host.sums), "{link}: {now}, on this computer {:?}", host.sums);
    Ok((pressed, link))
}

/// Fails where something of the page is beside a screen of that width, or the picture is another one there.
fn fits(page: &mut Page<'_>, width: u32, height: u32, expected: &Played) -> Result<()> {
    page.resize(width, height)?;
    let seen = played_in(page, &[&expected.link])?;
    ensure!(seen.first() == Some(&expected.sums), "{}: {seen:?} at {width} pixels", expected.link);
    let beside =
        "[...document.querySelectorAll('canvas, select, button, a, label, h1, h2, dt, dd, pre')].filter((part) => {
        const { left, right } = part.getBoundingClientRect();
        return left < 0 || right > innerWidth;
    }).map((part) => part.id || part.textContent)";
    let beside = page.evaluate(beside)?;
    ensure!(beside == json!([]), "beside a screen {width} pixels wide: {beside}");
    let scrolls = page.evaluate("document.documentElement.scrollWidth > innerWidth")?;
    ensure!(scrolls == false, "the page is wider than {width} pixels");
    let small = "[...document.querySelectorAll('select, button')].filter((part) => part.getBoundingClientRect().height < 40).map((part) => part.id)";
    let small = page.evaluate(small)?;
    ensure!(small == json!([]), "too small for a finger: {small}");
    Ok(())
}

/// Opens the page as a file.
fn from_folder(browser: &mut Browser, folder: &Path, expected: &Played) -> Result<()> {
    let path = folder.join("index.html");
    let mut page = browser.open(&format!("file://{}#{}", path.display(), expected.link))?;
    wait_for_start(&mut page)?;
    let seen = page.evaluate("[playground.memoryCrc(), playground.pictureCrc()]")?;
    ensure!(seen == json!(expected.sums), "{}: {seen} from a folder", expected.link);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_has_its_source() {
        let sources = sources().expect("all files are there");
        for (scene, file) in SOURCES {
            assert_eq!(sources[scene]["file"], file, "{scene}");
            let text = sources[scene]["text"].as_str().expect("a text");
            assert!(text.starts_with("//! "), "{file} says what it is");
        }
        assert_eq!(sources.as_object().map(serde_json::Map::len), Some(SOURCES.len()), "no scene twice");
    }

    #[test]
    fn a_line_is_a_choice_and_two_sums() {
        let played = parse("scene=page&refresh=4;0000000a;0000000b").expect("well-formed");
        assert_eq!(
            (played.link.as_str(), played.sums),
            ("scene=page&refresh=4", ["0000000a", "0000000b"].map(Into::into))
        );
        assert!(parse("scene=page").is_err(), "no sums");
    }
}
