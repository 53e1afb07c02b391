//! Sorting by a number, with one instance of the algorithm for all types: each costs 2 kB of what a browser loads first.

/// Sorts ascending by a number of each item; equal ones keep their order. −0 comes before 0, and NaN last.
pub(crate) fn sort_by_number<T>(items: &mut Vec<T>, number: impl Fn(&T) -> f64) {
    let order = ascending(items.iter().map(number).collect());
    let mut given: Vec<Option<T>> = items.drain(..).map(Some).collect();
    items.extend(order.into_iter().filter_map(|(_, index)| given[index].take()));
}

/// The numbers in ascending order, with their indices.
fn ascending(numbers: Vec<f64>) -> Vec<(f64, usize)> {
    let mut order: Vec<(f64, usize)> = numbers.into_iter().enumerate().map(|(index, number)| (number, index)).collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_ascend_and_equal_ones_keep_their_order() {
        let mut items = vec![(2.0, 'a'), (f64::NAN, 'b'), (-1.0, 'c'), (2.0, 'd'), (0.0, 'e'), (-1.0, 'f')];
        sort_by_number(&mut items, |item| item.0);
        assert_eq!(items.iter().map(|item| item.1).collect::<String>(), "cfeadb");
    }
}
