//! Puts the memory map of the emulated board where the linker looks for `memory.x`.

use std::{env, error::Error, fs, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    let map = match env::var("CARGO_CFG_TARGET_ARCH")?.as_str() {
        "arm" => "mps2.x",
        "riscv32" => "virt.x",
        other => return Err(format!("no board with a {other} processor").into()),
    };
    let out = env::var("OUT_DIR")?;
    fs::copy(map, Path::new(&out).join("memory.x"))?;
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rerun-if-changed={map}");
    Ok(())
}
