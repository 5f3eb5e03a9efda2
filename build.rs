//! Chooses between ways for speed and ways for size. `cfg` does not know the opt-level: at "s" and "z", or if the user says
//! so, this sets `embedded_raster_compact`.

use std::env::{var, VarError};

/// `size` or `speed`. Where it is not set, the opt-level decides.
const TUNE: &str = "EMBEDDED_RASTER_TUNE";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={TUNE}");
    println!("cargo::rustc-check-cfg=cfg(embedded_raster_compact, embedded_raster_small_core)");
    let compact = match var(TUNE).as_deref() {
        Ok("size") => true,
        Ok("speed") => false,
        Err(VarError::NotPresent) => var("OPT_LEVEL").is_ok_and(|level| level == "s" || level == "z"),
        Ok(other) => return refuse(other),
        Err(VarError::NotUnicode(other)) => return refuse(&other.to_string_lossy()),
    };
    if compact {
        println!("cargo::rustc-cfg=embedded_raster_compact");
    }
}

fn refuse(value: &str) {
    println!("cargo::error={TUNE} is `{}`: it may be `size` or `speed`, or not set", value.escape_debug());
}
