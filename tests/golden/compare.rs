//! Pictures against those in `tests/golden`.

use std::{env, path::Path};

use embedded_raster_simulator::Picture;

pub(crate) fn is_blessing() -> bool {
    env::var_os("BLESS").is_some_and(|bless| bless == "1")
}

/// Compares a picture with the one of that name; says what is wrong with it. With `BLESS=1`, writes it.
pub(crate) fn compare(name: &str, picture: &Picture) -> Option<String> {
    // Tests and examples of several packages are compared.
    let mut folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|folder| folder.join("tests/golden"));
    let folder = folders.find(|folder| folder.is_dir()).expect("a folder of pictures");
    let golden = folder.join(format!("{name}.png"));
    if is_blessing() {
        picture.write_png(&golden).expect("pictures can be written");
        return None;
    }
    let expected = Picture::read_png(&golden);
    if expected.as_ref().is_ok_and(|expected| expected == picture) {
        return None;
    }
    let actual = folder.join(format!("{name}.actual.png"));
    picture.write_png(&actual).expect("pictures can be written");
    Some(match expected {
        Err(error) => format!("{}: {error}; drawn: {}", golden.display(), actual.display()),
        Ok(expected) => {
            let difference = expected.difference(picture);
            let marked = folder.join(format!("{name}.difference.png"));
            difference.picture.write_png(&marked).expect("pictures can be written");
            let (pixels, actual, marked) = (difference.pixels, actual.display(), marked.display());
            format!("{name}: {pixels} pixels differ; drawn: {actual}, where: {marked}")
        }
    })
}
