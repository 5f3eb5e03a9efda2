//! Chooses between ways for speed and ways for size. `cfg` does not know the opt-level: at "s" and "z", or if the user says
//! so, this sets `embedded_raster_compact`. Where a test asks for the ways of a small core, it sets `embedded_raster_small_core`.
//! Where neither is set, and the chip has vector registers, it sets `embedded_raster_vectors`.

use std::env::{var, VarError};

/// `size` or `speed`. Where it is not set, the opt-level decides.
const TUNE: &str = "EMBEDDED_RASTER_TUNE";

/// `small`, for tests. As `--cfg` in `RUSTFLAGS` it would make cargo compile all dependencies anew.
const CORE: &str = "EMBEDDED_RASTER_CORE";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={TUNE}");
    println!("cargo::rerun-if-env-changed={CORE}");
    println!(
        "cargo::rustc-check-cfg=cfg(embedded_raster_compact, embedded_raster_small_core, embedded_raster_vectors)"
    );
    let compact = match var(TUNE).as_deref() {
        Ok("size") => true,
        Ok("speed") => false,
        Err(VarError::NotPresent) => var("OPT_LEVEL").is_ok_and(|level| level == "s" || level == "z"),
        Ok(other) => return refuse(TUNE, other, "`size` or `speed`"),
        Err(VarError::NotUnicode(other)) => return refuse(TUNE, &other.to_string_lossy(), "`size` or `speed`"),
    };
    let small_core = match var(CORE).as_deref() {
        Ok("small") => true,
        Err(VarError::NotPresent) => false,
        Ok(other) => return refuse(CORE, other, "`small`"),
        Err(VarError::NotUnicode(other)) => return refuse(CORE, &other.to_string_lossy(), "`small`"),
    };
    if compact {
        println!("cargo::rustc-cfg=embedded_raster_compact");
    }
    if small_core {
        println!("cargo::rustc-cfg=embedded_raster_small_core");
    }
    let has_vectors = var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "x86_64" || arch == "aarch64");
    if has_vectors && !compact && !small_core {
        println!("cargo::rustc-cfg=embedded_raster_vectors");
    }
}

fn refuse(variable: &str, value: &str, allowed: &str) {
    println!("cargo::error={variable} is `{}`: it may be {allowed}, or not set", value.escape_debug());
}
