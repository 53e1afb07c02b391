//! The ordered list of edges that the sweep line of [`super::sweep`] meets.
//!
//! Stored as chunks of bounded length: insertion moves a few hundred small
//! integers at most, and search takes O(log n) orientation tests. A balanced tree
//! would not be faster at 200,000 edges.

const MAX_CHUNK: usize = 512;

/// Edge indices from bottom to top. No chunk is empty.
#[derive(Debug, Default)]
pub(super) struct Status {
    chunks: Vec<Vec<u32>>,
}

/// A place in the list: the chunk, and the index within it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    chunk: usize,
    index: usize,
}

impl Status {
    /// The first place whose edge is not `below`; `below` must hold for a prefix.
    pub fn search(&self, below: impl Fn(u32) -> bool) -> Place {
        let chunk = self.chunks.partition_point(|c| c.last().is_some_and(|&e| below(e)));
        let index = self.chunks.get(chunk).map_or(0, |c| c.partition_point(|&e| below(e)));
        Place { chunk, index }
    }

    /// The edge there, if the place is not the end.
    pub fn get(&self, p: Place) -> Option<u32> {
        self.chunks.get(p.chunk)?.get(p.index).copied()
    }

    /// The edge one below the place.
    pub fn before(&self, p: Place) -> Option<u32> {
        match p.index.checked_sub(1) {
            Some(i) => self.chunks.get(p.chunk)?.get(i).copied(),
            None => self.chunks.get(p.chunk.checked_sub(1)?)?.last().copied(),
        }
    }

    /// The next place towards the top.
    pub fn next(&self, p: Place) -> Place {
        let length = self.chunks.get(p.chunk).map_or(0, Vec::len);
        if p.index + 1 < length { Place { index: p.index + 1, ..p } } else { Place { chunk: p.chunk + 1, index: 0 } }
    }

    /// Replaces the edge at place `p` by `edge`.
    pub fn replace(&mut self, p: Place, edge: u32) {
        if let Some(slot) = self.chunks.get_mut(p.chunk).and_then(|c| c.get_mut(p.index)) {
            *slot = edge;
        }
    }

    /// Inserts two edges, `lower` first, before place `p`.
    pub fn insert_pair(&mut self, p: Place, lower: u32, upper: u32) {
        // The end of the list belongs to the last chunk.
        let (chunk, index) = match (self.chunks.get(p.chunk), self.chunks.last()) {
            (Some(_), _) => (p.chunk, p.index),
            (None, Some(last)) => (self.chunks.len() - 1, last.len()),
            (None, None) => return self.chunks.push(vec![lower, upper]),
        };
        let list = &mut self.chunks[chunk];
        list.splice(index..index, [lower, upper]);
        if list.len() > MAX_CHUNK {
            let upper_half = list.split_off(MAX_CHUNK / 2);
            self.chunks.insert(chunk + 1, upper_half);
        }
    }

    /// Removes the edge at place `p` and returns the place of the edge that was above it.
    pub fn remove(&mut self, p: Place) -> Place {
        if let Some(list) = self.chunks.get_mut(p.chunk)
            && p.index < list.len()
        {
            list.remove(p.index);
            if list.is_empty() {
                self.chunks.remove(p.chunk);
                return Place { chunk: p.chunk, index: 0 };
            }
        }
        self.normalize(p)
    }

    /// The same place, written as the start of the next chunk at a chunk's end.
    fn normalize(&self, p: Place) -> Place {
        let length = self.chunks.get(p.chunk).map_or(0, Vec::len);
        if p.index < length { p } else { Place { chunk: p.chunk + 1, index: 0 } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn listed(status: &Status) -> Vec<u32> {
        status.chunks.iter().flatten().copied().collect()
    }

    #[test]
    fn pairs_stay_in_order_through_splits_and_removals() {
        let mut status = Status::default();
        // 3, 1, 4, 1, 5 …: a fixed scrambled order of even keys.
        let keys: Vec<u32> = (0..3000u32).map(|k| 2 * ((k * 1103) % 3000)).collect();
        for &k in &keys {
            let place = status.search(|e| e < k);
            status.insert_pair(place, k, k + 1);
        }
        assert_eq!(listed(&status), (0..6000).collect::<Vec<_>>());
        assert!(status.chunks.len() > 5 && status.chunks.iter().all(|c| !c.is_empty() && c.len() <= MAX_CHUNK));

        for &k in &keys[..2990] {
            let place = status.search(|e| e < k);
            assert_eq!(status.get(place), Some(k));
            let place = status.remove(place);
            assert_eq!(status.get(place), Some(k + 1), "the edge above follows");
            let place = status.remove(place);
            assert_eq!(status.get(place), listed(&status).into_iter().find(|&e| e > k));
            assert_eq!(status.before(place), listed(&status).into_iter().rfind(|&e| e < k));
        }
        let mut left: Vec<u32> = keys[2990..].iter().flat_map(|&k| [k, k + 1]).collect();
        left.sort_unstable();
        assert_eq!(listed(&status), left);
    }
}
