//! The list of calls has everything that is public and computes: `tests/finder` finds it in the sources.

mod finder;

use std::{collections::BTreeMap, path::Path};

use calls::{blending, computing, damage, frames, paths, present, shading, space, texts, DRAWING, READING};
use finder::Source;

/// What need not be in the list, by name or by owner, and why.
const ELSEWHERE: &[(&str, &str)] = &[
    ("Layout", "frames call it, with places in memory; a program that does so itself has to clip them"),
    ("Sink", "shapes call it"),
    ("Paint", "brushes call it"),
    ("FloodTarget", "floods call it"),
    ("Varying", "planes call it"),
    ("Small", "shades of small triangles call it"),
    ("Depth", "shades with depths call it"),
    ("DepthCell", "the same"),
    ("DepthOf", "triangles with depths call it"),
    ("Channels", "textures call it"),
    ("Numbers", "values in perspective call it"),
    ("AddressMode", "the same"),
    ("Index", "`assemble` calls it"),
    ("Texture::clone", "a copy"),
    ("Sheet::clone", "a copy"),
    ("Gamma::power", "for constants"),
    ("$vector", "operators of vectors: `Vec3::new`, `Vec4::new` and those beside them are listed with them"),
    ("PixelFormat", "every call on a frame packs and unpacks"),
    ("Surface::window", "every call asks for it"),
    ("Surface::fill_inside", "its first argument cannot be made outside of the crate"),
    ("Surface::fill_strip", "the same"),
    ("Surface::pairs", "text calls it"),
    ("Surface::write_inside", "the same"),
    ("Surface::write_span_inside", "the same"),
    ("Surface::write_few_inside", "the same"),
    ("Surface::write_rows_inside", "the same"),
    ("Surface::write_parts_inside", "the same"),
    ("Brush::new", "`Canvas::paint` makes one"),
    ("Cut", "not to be named outside of the crate; strokes call it"),
    ("Outline", "the same"),
    ("Whole", "the same"),
    ("Error", "it wraps another error"),
    ("Frame::clone", "a copy"),
    ("Swapchain::begin_async", "a future panics when it is polled after its end, as all do"),
    ("bands::for_each_band_async", "the same"),
    ("Queues", "queues of the crate heapless, which keep a check of their own; `present` tries all that can happen"),
    ("Drawer", "the same"),
    ("Display", "the same"),
    // Colours: a few bits from and to others, without coordinates and without memory.
    ("$name", "every index and every colour that a macro makes"),
    ("$raw", "out of them"),
    ("u8", "out of them"),
    ("Index1", "out of other colours"),
    ("Index2", "the same"),
    ("Index4", "the same"),
    ("Index8", "the same"),
    ("Rgb332", "the same"),
    ("Rgb444", "the same"),
    ("Rgb888", "the same"),
    ("Xrgb8888", "the same"),
    ("Argb8888::from", "out of its bits"),
    ("RawU8", "the same"),
    ("RawU16", "the same"),
    ("RawU32", "the same"),
];

/// Names with how often they are there.
fn count<S: AsRef<str>>(names: impl IntoIterator<Item = S>) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for name in names {
        *counts.entry(name.as_ref().to_owned()).or_default() += 1;
    }
    counts
}

#[test]
fn the_list_is_complete() {
    let source = Source::of_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    let is_elsewhere = |name: &String| {
        let owner = name.split("::").next().expect("a name has an owner");
        let function = name.rsplit("::").next().expect("a name");
        ELSEWHERE.iter().any(|(elsewhere, _)| elsewhere == name || *elsewhere == owner)
            // What `Debug`, `Display` and `defmt::Format` ask for.
            || ["fmt", "format"].contains(&function)
    };
    let wanted = count(source.names().into_iter().filter(|name| !is_elsewhere(name)));
    let lists = [
        DRAWING,
        READING,
        frames::NAMES,
        computing::NAMES,
        damage::NAMES,
        blending::NAMES,
        paths::NAMES,
        present::NAMES,
        shading::NAMES,
        space::NAMES,
        texts::NAMES,
    ];
    let listed = count(lists.concat());
    let lacks = |these: &BTreeMap<String, usize>, those: &BTreeMap<String, usize>| -> Vec<String> {
        these.iter().filter(|(name, n)| those.get(*name).is_none_or(|m| m < *n)).map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(lacks(&wanted, &listed), Vec::<String>::new(), "calls that the list lacks");
    assert_eq!(lacks(&listed, &wanted), Vec::<String>::new(), "calls that do not exist");
    assert_eq!(source.foreign, Vec::<String>::new(), "functions of other crates, which nobody sees here");
}

/// What could hide a function from whoever reads the text.
#[test]
fn nothing_hides_from_the_finder() {
    let mut source = Source::default();
    source.add(
        r##"
        //! pub fn in_a_comment() {}
        /* pub fn in_one /* inside another */ pub fn still_in_it() {} */
        use core::fmt;
        pub use fixed::traits::Fixed;
        pub use self::inner::deep as shallow;
        pub const TEXT: &str = "pub fn in_a_string() { \" }";
        const RAW: &str = r#"pub fn in_a_raw_string() { " "#;
        const BRACE: (char, u8) = ('{', b'\'');
        pub mod inner {
            pub(crate) fn for_the_crate() {}
            pub(in crate::inner) fn for_a_module() {}
            pub fn deep<'a, T>(a: &'a [T; { 3 }]) -> impl Fn(u8) -> u8 + use<'a, T>
            where
                T: Into<u8>,
            {
                pub fn inside_of_a_function() {}
                |n| n
            }
        }
        pub
        const
        fn over_lines() {}
        pub unsafe extern "C" fn foreign() {}
        #[inline] #[must_use = "it is"] pub async fn with_attributes() {}
        #[doc(hidden)] pub fn hidden() {}
        #[cfg(test)] mod tests { pub fn in_tests() {} }
        #[cfg(not(test))] pub fn outside_of_tests() {}
        fn private() {}
        pub struct Shape<T>(T);
        struct Private;
        impl<T: Fn(u8) -> u8> Shape<T> where T: Copy {
            pub const EMPTY: [u8; 2] = { pub fn of_a_constant() {} [0; 2] };
            pub fn method(&self) {}
            fn private_method(&self) {}
        }
        impl<T> crate::inner::Seam for Shape<T> { fn of_a_seam(&self) {} }
        impl<'a, T> core::ops::Add<&'a T> for &mut Shape<T> { type Output = u8; fn add(self, _: &T) -> u8 { 0 } }
        impl From<Shape<u8>> for core::Foreign { fn from(_: Shape<u8>) -> Self {} }
        impl Iterator for Private { fn next(&mut self) {} }
        impl Private { pub(super) fn part(&self) {} }
        pub trait Seam: Copy { const N: u8 = { 3 }; fn of_a_seam(&self); fn with_default(&self) where Self: Sized {} }
        trait Hidden { fn of_a_hidden_trait(&self); }
        macro_rules! make {
            ($name:ident) => {
                pub struct $name(u8);
                impl $name { pub const fn new() -> Self { Self(0) } }
                impl From<$name> for u8 { fn from(_: $name) -> u8 { 0 } }
            };
            ($vis:vis $name:ident, $n:literal) => { $vis fn $name() {} };
        }
        make! { Made }
        pub fn last() {}
        "##,
        "module",
    );
    let names = source.names();
    let mut wanted = [
        "inner::deep",
        "module::over_lines",
        "module::foreign",
        "module::with_attributes",
        "module::hidden",
        "module::outside_of_tests",
        "Shape::method",
        "Shape::add",
        "Foreign::from",
        "Seam::of_a_seam",
        "Seam::with_default",
        "$name::new",
        "u8::from",
        "module::$name",
        "module::last",
    ];
    wanted.sort_unstable();
    assert_eq!(names, wanted);
    assert_eq!(source.foreign, ["fixed::traits::Fixed"]);
}
