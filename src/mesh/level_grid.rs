//! Points, each with a size, found by distance at the scale of the size.
//!
//! One hashed grid per power of two: a point of size s is entered at its own
//! level and at the two adjacent ones, so a query at size s finds all
//! nearby points whose sizes differ by less than a factor of two. Points of
//! very different size are missed. Buckets may hold points of other cells;
//! callers compare distances anyway.

use crate::geometry::DVec2;

const NONE: u32 = u32::MAX;

/// The points, their sizes and the hash table.
#[derive(Debug, Default)]
pub(super) struct LevelGrid {
    positions: Vec<DVec2>,
    sizes: Vec<f64>,
    /// The first entry of each bucket; the number of buckets is a power of two.
    heads: Vec<u32>,
    /// The entry after entry `3 point + slot` in its bucket.
    next: Vec<[u32; 3]>,
}

impl LevelGrid {
    pub fn positions(&self) -> &[DVec2] {
        &self.positions
    }

    pub fn size(&self, k: u32) -> f64 {
        self.sizes[k as usize]
    }

    pub fn insert(&mut self, p: DVec2, size: f64) {
        self.positions.push(p);
        self.sizes.push(size);
        self.next.push([NONE; 3]);
        if 4 * self.positions.len() > self.heads.len() {
            self.heads = vec![NONE; (4 * self.heads.len()).max(16_384)];
            (0..self.positions.len()).for_each(|k| self.enter(k));
        } else {
            self.enter(self.positions.len() - 1);
        }
    }

    fn enter(&mut self, k: usize) {
        let own = level(self.sizes[k]);
        for slot in 0..3 {
            let at = own + slot - 1;
            let cell = self.positions[k] * cells_per_unit(at);
            let bucket = self.bucket(at, floor(cell.x), floor(cell.y));
            self.next[k][slot as usize] = self.heads[bucket];
            self.heads[bucket] = 3 * k as u32 + slot as u32;
        }
    }

    fn bucket(&self, level: i32, x: i64, y: i64) -> usize {
        let mix = (x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ (y as u64).wrapping_mul(0xc2b2_ae3d_27d4_eb4f)
            ^ (level as u64).wrapping_mul(0x1656_67b1_9e37_79f9);
        (mix.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) as usize & (self.heads.len() - 1)
    }

    /// Whether `test(distance, size)` holds for any point within `radius` of `p`, searched at the level of `radius`.
    pub fn any_within(&self, p: DVec2, radius: f64, mut test: impl FnMut(f64, f64) -> bool) -> bool {
        let level = level(radius);
        let scale = cells_per_unit(level);
        let (own, low, high) = (p * scale, (p - radius) * scale, (p + radius) * scale);
        let own = (floor(own.x), floor(own.y));
        let mut in_cell = |x: i64, y: i64| {
            let mut entry = self.heads[self.bucket(level, x, y)];
            while entry != NONE {
                let (k, slot) = (entry as usize / 3, entry as usize % 3);
                let distance = self.positions[k].distance_squared(p);
                if distance < radius * radius && test(distance.sqrt(), self.sizes[k]) {
                    return true;
                }
                entry = self.next[k][slot];
            }
            false
        };
        // usually a point in the same cell answers yes
        if in_cell(own.0, own.1) {
            return true;
        }
        let (columns, rows) = (floor(low.x)..=floor(high.x), floor(low.y)..=floor(high.y));
        rows.flat_map(|y| columns.clone().map(move |x| (x, y))).any(|(x, y)| (x, y) != own && in_cell(x, y))
    }
}

/// `⌊log₂ size⌋`, for positive normal numbers.
fn level(size: f64) -> i32 {
    ((size.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// The cells of level `l` are `2^(l+1)` wide: at least as wide as the sizes in it.
fn cells_per_unit(level: i32) -> f64 {
    f64::from_bits(((1022 - level).clamp(1, 2046) as u64) << 52)
}

/// `⌊x⌋`, inline where the target has no instruction for it.
fn floor(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero.saturating_sub(i64::from(towards_zero as f64 > x))
}
