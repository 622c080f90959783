//! Places from which, together, a robot sees the whole field.

use bica_field::FieldDimensions;
use glam::Vec2;
use libm::{ceilf, sqrtf};

/// Largest number of cells along a side of the field: the set of searched cells has 32 bits.
const MAX_CELLS: f32 = 5.0;

/// Middles of the equal cells of the field: none of their points is further from the middle than the robot sees.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    /// Corner of the field at the opponents' goal and on the left, m.
    corner: Vec2,
    /// Extent of a cell, m.
    cell: Vec2,
    columns: usize,
    count: usize,
}

impl Grid {
    /// The largest cells for a distance at which the robot sees what it searches for, m.
    fn of(field: &FieldDimensions, view_distance: f32) -> Self {
        let corner = field.field_corner();
        let field = 2.0 * corner;
        let number = |length: f32, cell: f32| ceilf(length / cell).clamp(1.0, MAX_CELLS);
        let diagonal = 2.0 * view_distance;
        let columns = number(field.x, diagonal / core::f32::consts::SQRT_2);
        let length = field.x / columns;
        let width = sqrtf((diagonal * diagonal - length * length).max(length * length));
        let rows = number(field.y, width);
        let cell = Vec2::new(length, field.y / rows);
        Self { corner, cell, columns: columns as usize, count: (columns * rows) as usize }
    }

    /// Middle of a cell, m, field frame.
    fn middle(&self, index: usize) -> Vec2 {
        let (column, row) = (index % self.columns, index / self.columns);
        (Vec2::new(column as f32, row as f32) + 0.5) * self.cell - self.corner
    }
}

/// Places on the field from which the robot has searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Viewpoints {
    /// A bit for each cell of the grid.
    searched: u32,
}

impl Viewpoints {
    /// No place.
    pub(crate) const NONE: Self = Self { searched: 0 };

    /// Notes that the robot has searched from a position, m: that counts for a place next to it.
    pub(crate) fn note(&mut self, field: &FieldDimensions, view_distance: f32, at: Vec2) {
        let grid = Grid::of(field, view_distance);
        for index in 0..grid.count {
            if grid.middle(index).distance(at) < 0.25 * view_distance {
                self.searched |= 1 << index;
            }
        }
    }

    /// Returns the place of least cost that is not searched, m, and counts it as searched; after the last one the search begins anew.
    pub(crate) fn next(&mut self, field: &FieldDimensions, view_distance: f32, cost: impl Fn(Vec2) -> f32) -> Vec2 {
        let grid = Grid::of(field, view_distance);
        if self.searched.count_ones() as usize >= grid.count {
            self.searched = 0;
        }
        let open = (0..grid.count).filter(|index| self.searched >> index & 1 == 0);
        let best = open.min_by(|a, b| cost(grid.middle(*a)).total_cmp(&cost(grid.middle(*b)))).unwrap_or(0);
        self.searched |= 1 << best;
        grid.middle(best)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use bica_field::FIELD;

    use super::*;

    #[test]
    fn each_point_of_the_field_is_in_view_of_a_place() {
        for view_distance in [1.5, 2.0, 2.4, 4.0, 9.0] {
            let mut places = Viewpoints::NONE;
            let grid = Grid::of(&FIELD, view_distance);
            let seen: std::vec::Vec<Vec2> =
                (0..grid.count).map(|_| places.next(&FIELD, view_distance, |at| at.x)).collect();
            for x in 0_u8..=24 {
                for y in 0_u8..=16 {
                    let at = (Vec2::new(x.into(), y.into()) / Vec2::new(12.0, 8.0) - 1.0) * FIELD.field_corner();
                    let nearest = seen.iter().map(|place| place.distance(at)).fold(f32::INFINITY, f32::min);
                    assert!(nearest <= view_distance + 1e-3, "{view_distance} m: {at} is {nearest} m away");
                }
            }
        }
    }

    #[test]
    fn searched_places_are_left_out_until_all_are() {
        let mut places = Viewpoints::NONE;
        let ahead = |at: Vec2| -at.x;
        assert_eq!(Grid::of(&FIELD, 2.6).count, 2);
        let (front, back) = (places.next(&FIELD, 2.6, ahead), places.next(&FIELD, 2.6, ahead));
        assert!(front.x > 0.0 && back.x < 0.0, "{front} {back}");
        assert_eq!(places.next(&FIELD, 2.6, ahead), front, "the search begins anew");
        let mut places = Viewpoints::NONE;
        places.note(&FIELD, 2.6, front + 0.3);
        assert_eq!(places.next(&FIELD, 2.6, ahead), back);
    }
}
