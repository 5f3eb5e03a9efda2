//! Triangles whose cost is measured, the same on every chip and on the host.

/// A corner: a place in 1/256 pixel, and what is there.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Corner {
    /// The place.
    pub at: [i32; 2],
    /// Red, green and blue, as RGB565 has them: up to 31, 63 and 31.
    pub levels: [i32; 3],
    /// How far away, as a depth buffer has it: of 16 bits, or of 32.
    pub depth: u32,
    /// Column and row in a texture, in texels.
    pub texel: [i32; 2],
    /// How far away, as the w of clip space: whole, positive.
    pub w: i32,
}

/// Three corners.
pub type Triangle = [Corner; 3];

/// A colour of a byte.
const fn levels(byte: i32) -> [i32; 3] {
    [byte >> 3, 63 - (byte >> 2), 31 - (byte >> 4)]
}

const fn corner(at: [i32; 2], byte: i32, texel: [i32; 2], w: i32) -> Corner {
    Corner { at, levels: levels(byte), depth: 0, texel, w }
}

/// About 20,000 pixels.
pub const LARGE: [Triangle; 1] = [[
    corner([30 * 256, 20 * 256], 250, [0, 0], 2),
    corner([290 * 256, 70 * 256], 3, [230, 3], 4),
    corner([114 * 256, 190 * 256], 120, [40, 170], 7),
]];

/// Triangles of about 100 pixels, of several shapes and both windings, in a grid of cells 20 pixels wide.
pub fn small() -> [Triangle; 120] {
    core::array::from_fn(|i| {
        let (x, y, n) = ((i % 15 * 20) as i32 * 256, (i / 15 * 20) as i32 * 256, i as i32);
        let b = corner([x + 15 * 256 + n * 37 % 900, y + n * 91 % 700], (n * 29) & 255, [n % 60, 5], 3);
        let c = corner([x + n * 53 % 800, y + 13 * 256 + n * 77 % 800], (n * 71) & 255, [5, n * 7 % 60], 4);
        let a = corner([x + n * 17 % 256, y], 255, [20, 20], 4);
        if i % 2 == 0 {
            [a, b, c]
        } else {
            [c, b, a]
        }
    })
}

/// Columns and rows of the mesh, whose cells are about 10 pixels wide and high.
const GRID: usize = 10;

/// How many layers the mesh has. Each is bent, so that they pass through each other.
const LAYERS: usize = 4;

/// The size of what the mesh is drawn on.
pub const MESH_SIZE: (u16, u16) = (130, 120);

fn bend(layer: usize, (column, row): (usize, usize)) -> Corner {
    let (i, j, n) = (column as i32, row as i32, layer as i32);
    let at = [2600 * i + j * 97 % 300 + 3000 + n * 61, 2550 * j + i * 83 % 300 + 2000 + n * 47];
    let depth = 30_000 + n * 900 + (i - 5) * (j - 4) * (if n % 2 == 0 { 300 } else { -300 }) + i * 211 % 170;
    Corner { at, depth: depth as u32, levels: levels((i * 29 + j * 53 + n * 71) & 255), texel: [0; 2], w: 1 }
}

/// Triangles of about 50 pixels: layer by layer, two for each cell.
pub fn mesh() -> [Triangle; LAYERS * GRID * GRID * 2] {
    core::array::from_fn(|index| {
        let (layer, cell) = (index / (GRID * GRID * 2), index / 2 % (GRID * GRID));
        let (i, j) = (cell % GRID, cell / GRID);
        let corner = |i, j| bend(layer, (i, j));
        if index % 2 == 0 {
            [corner(i, j), corner(i + 1, j), corner(i, j + 1)]
        } else {
            [corner(i + 1, j + 1), corner(i, j + 1), corner(i + 1, j)]
        }
    })
}
