//! What is kept of a window: pictures and films, in files that are made when somebody presses a key.

use std::{
    fs, io,
    path::{Path, PathBuf},
    time::Duration,
};

use crate::{film, picture::Picture};

/// Between two pictures of a film: browsers show what is faster more slowly.
const LEAST: Duration = Duration::from_millis(20);
/// Pictures of a film: then it ends by itself.
const MOST: usize = 1500;

/// What a film becomes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Gif,
    Apng,
}

impl Kind {
    /// How the names of its files end. An APNG is a PNG, but this is how people tell it apart.
    fn end(self) -> &'static str {
        match self {
            Self::Gif => "gif",
            Self::Apng => "apng",
        }
    }
}

/// Writes files beside each other: `NAME-1.png`, `NAME-2.png` ...
#[derive(Debug)]
pub(super) struct Recorder {
    folder: PathBuf,
    name: String,
    film: Option<Film>,
}

/// A film that is being made.
#[derive(Debug)]
struct Film {
    kind: Kind,
    /// Each with the moment from which it was shown.
    pictures: Vec<(Picture, Duration)>,
}

impl Recorder {
    pub(super) fn new(folder: impl AsRef<Path>, title: &str) -> Self {
        let letter = |c: char| if c.is_alphanumeric() { c } else { '-' };
        Self { folder: folder.as_ref().into(), name: title.chars().map(letter).collect(), film: None }
    }

    /// Writes a picture.
    pub(super) fn screenshot(&self, picture: &Picture) -> io::Result<PathBuf> {
        self.write("png", &picture.to_png()?)
    }

    /// Begins a film, or ends the one that is being made: then it is written.
    pub(super) fn toggle(&mut self, kind: Kind, picture: &Picture, now: Duration) -> io::Result<Option<PathBuf>> {
        let before = self.film.as_ref().map(|film| film.kind);
        let written = self.finish(now)?;
        if before != Some(kind) {
            self.film = Some(Film { kind, pictures: vec![(picture.clone(), now)] });
        }
        Ok(written)
    }

    /// What is shown from now on. A film of the longest length ends, and is written.
    pub(super) fn see(&mut self, picture: &Picture, now: Duration) -> io::Result<Option<PathBuf>> {
        let Some(film) = &mut self.film else { return Ok(None) };
        if film.pictures.len() >= MOST {
            return self.finish(now);
        }
        match film.pictures.last_mut() {
            Some((last, _)) if last == picture => {}
            // What was shown for a moment only is not in the film.
            Some((last, since)) if now < *since + LEAST => *last = picture.clone(),
            _ => film.pictures.push((picture.clone(), now)),
        }
        Ok(None)
    }

    /// Whether a film is being made.
    pub(super) fn is_filming(&self) -> bool {
        self.film.is_some()
    }

    /// Writes the film that is being made, if there is one.
    pub(super) fn finish(&mut self, now: Duration) -> io::Result<Option<PathBuf>> {
        let Some(Film { kind, pictures }) = self.film.take() else { return Ok(None) };
        let timed = delays(pictures, now);
        let bytes = match kind {
            Kind::Gif => film::timed_gif(&timed)?,
            Kind::Apng => film::timed_apng(&timed)?,
        };
        self.write(kind.end(), &bytes).map(Some)
    }

    /// Writes a file of the first number that is free.
    fn write(&self, end: &str, bytes: &[u8]) -> io::Result<PathBuf> {
        for number in 1_u32.. {
            let path = self.folder.join(format!("{}-{number}.{end}", self.name));
            match fs::File::create_new(&path) {
                Ok(mut file) => return io::Write::write_all(&mut file, bytes).map(|()| path),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(io::Error::new(error.kind(), format!("{}: {error}", path.display()))),
            }
        }
        unreachable!("there are fewer files than numbers")
    }
}

/// For how long each is shown, in hundredths of a second. Moments are rounded, not lengths: a long film does not run away from what it
/// shows.
fn delays(pictures: Vec<(Picture, Duration)>, end: Duration) -> Vec<(Picture, u16)> {
    let hundredths = |moment: Duration| (moment.as_millis() + 5) / 10;
    let next: Vec<_> = pictures.iter().skip(1).map(|(_, since)| *since).chain([end]).collect();
    let delay = |from, to| u16::try_from(hundredths(to).saturating_sub(hundredths(from))).unwrap_or(u16::MAX).max(2);
    pictures.into_iter().zip(next).map(|((picture, from), to)| (picture, delay(from, to))).collect()
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::Rgb888;

    use super::*;

    fn dot(red: u8) -> Picture {
        Picture::from_colors(1, 1, vec![Rgb888::new(red, 0, 0)])
    }

    fn millis(n: u64) -> Duration {
        Duration::from_millis(n)
    }

    /// A folder of its own, which goes when the test ends well.
    fn with_folder(name: &str, test: impl FnOnce(&Path) -> io::Result<()>) {
        let folder = std::env::temp_dir().join(format!("embedded-raster-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).and_then(|()| test(&folder)).expect("files can be written");
        fs::remove_dir_all(folder).expect("it is there");
    }

    #[test]
    fn no_file_is_written_over() {
        with_folder("screenshots", |folder| {
            let recorder = Recorder::new(folder, "my game");
            for number in 1..4 {
                let path = recorder.screenshot(&dot(number))?;
                assert_eq!(path, folder.join(format!("my-game-{number}.png")));
                assert_eq!(Picture::read_png(path)?, dot(number), "picture {number}");
            }
            Ok(())
        });
        assert!(Recorder::new("/no/such/folder", "x").screenshot(&dot(1)).is_err(), "an error is told");
    }

    #[test]
    fn films_keep_time() {
        let pictures = [0, 33, 67, 100, 100_000].map(|at| (dot(1), millis(at))).to_vec();
        let delays: Vec<_> = delays(pictures, millis(900_000)).into_iter().map(|(_, delay)| delay).collect();
        assert_eq!(delays, [3, 4, 3, 9_990, u16::MAX], "hundredths of a second");
    }

    #[test]
    fn a_film_has_what_was_seen() {
        with_folder("films", |folder| {
            let mut recorder = Recorder::new(folder, "game");
            assert_eq!(recorder.see(&dot(1), millis(0))?, None, "nobody asked");
            assert_eq!(recorder.finish(millis(5))?, None, "nothing to write");
            assert_eq!(recorder.toggle(Kind::Gif, &dot(1), millis(10))?, None, "it begins");
            assert!(recorder.is_filming(), "it goes on");
            for (red, at) in [(1, 30), (2, 50), (3, 60), (4, 90), (4, 120)] {
                assert_eq!(recorder.see(&dot(red), millis(at))?, None, "a picture");
            }
            let path = recorder.toggle(Kind::Gif, &dot(4), millis(150))?.expect("it is written");
            assert!(path.ends_with("game-1.gif") && !recorder.is_filming(), "{}", path.display());
            let mut options = ::gif::DecodeOptions::new();
            options.set_color_output(::gif::ColorOutput::RGBA);
            let mut reader = options.read_info(fs::File::open(path)?).expect("a GIF file");
            // The second picture was shown for 10 ms only: the third takes its place.
            for (red, delay) in [(1, 4), (3, 4), (4, 6)] {
                let frame = reader.read_next_frame().expect("no error").expect("a picture");
                assert_eq!((frame.buffer[0], frame.delay), (red, delay), "red and hundredths of a second");
            }
            assert!(reader.read_next_frame().expect("no error").is_none(), "three pictures");
            Ok(())
        });
    }

    #[test]
    fn another_kind_begins_another_film() {
        with_folder("kinds", |folder| {
            let mut recorder = Recorder::new(folder, "game");
            recorder.toggle(Kind::Gif, &dot(1), millis(0))?;
            assert_eq!(recorder.toggle(Kind::Apng, &dot(2), millis(99))?, Some(folder.join("game-1.gif")), "written");
            assert_eq!(recorder.finish(millis(199))?, Some(folder.join("game-1.apng")), "at the end");
            assert_eq!(Picture::read_png(folder.join("game-1.apng"))?, dot(2), "an APNG is a PNG");
            recorder.toggle(Kind::Apng, &dot(0), millis(0))?;
            let dots = [1, 0].into_iter().cycle().zip(1..=MOST as u64);
            let ends = dots.map(|(red, n)| recorder.see(&dot(red), millis(40 * n)));
            let written: Vec<_> = ends.collect::<io::Result<Vec<_>>>()?.into_iter().flatten().collect();
            assert_eq!(written, [folder.join("game-2.apng")], "the longest film");
            Ok(())
        });
    }
}
