//! A cart plans its path on a grid, beside the loop: the search takes longer than a cycle.
//!
//! `cargo run --example plan_path`

use bica::prelude::*;

const WIDTH: usize = 12;
const CELLS: usize = WIDTH * 6;

/// Occupied cells, row by row.
#[derive(Clone, Copy)]
struct Grid([bool; CELLS]);

impl Grid {
    /// The cells beside a cell.
    fn neighbours(cell: usize) -> impl Iterator<Item = usize> {
        let (row, column) = (cell / WIDTH, cell % WIDTH);
        let left = (column > 0).then(|| cell - 1);
        let right = (column + 1 < WIDTH).then(|| cell + 1);
        let (up, down) = ((row > 0).then(|| cell - WIDTH), Some(cell + WIDTH).filter(|cell| *cell < CELLS));
        [left, right, up, down].into_iter().flatten()
    }
}

/// Number of cells to the goal from each cell; none if there is no way.
struct Distances([Option<u8>; CELLS]);

/// What the sensors saw: shelves, and later a box.
struct Map {
    grid: Grid,
}

#[component]
impl Map {
    const fn new() -> Self {
        let (mut grid, mut row) = ([false; CELLS], 0);
        while row < 5 {
            grid[row * WIDTH + 4] = true;
            grid[(row + 1) * WIDTH + 8] = true;
            row += 1;
        }
        Self { grid: Grid(grid) }
    }
}

/// Finds the way to the goal, again if something stands in it.
struct Planner {
    goal: usize,
    distances: Option<Distances>,
}

#[component(hz = 10)]
impl Planner {
    const fn new() -> Self {
        Self { goal: CELLS - 1, distances: None }
    }

    /// Distances of all free cells to the goal.
    #[work(takes_ms = 200)]
    fn search(grid: Grid, goal: usize) -> Distances {
        let (mut distances, mut open) = ([None; CELLS], vec![(goal, 0)]);
        while let Some((cell, steps)) = open.pop() {
            if !grid.0[cell] && distances[cell].is_none_or(|known| steps < known) {
                distances[cell] = Some(steps);
                open.extend(Grid::neighbours(cell).map(|next| (next, steps + 1)));
            }
        }
        Distances(distances)
    }

    fn step(&mut self, work: &mut Work<Self>, map: &Map) {
        if let Some(distances) = work.result() {
            self.distances = Some(distances);
        }
        if self.distances.is_none() && work.is_idle() {
            work.begin(map.grid, self.goal);
        }
    }
}

/// Goes to the neighbour that is nearest to the goal, and waits while there is no plan.
struct Cart {
    cell: usize,
}

#[component(hz = 5)]
impl Cart {
    const fn new() -> Self {
        Self { cell: 0 }
    }

    fn step(&mut self, planner: &mut Planner, map: &Map) {
        let Some(Distances(distances)) = &planner.distances else { return };
        let next = Grid::neighbours(self.cell).filter(|cell| distances[*cell] < distances[self.cell]);
        match next.filter_map(|cell| Some((distances[cell]?, cell))).min() {
            Some((_, cell)) if map.grid.0[cell] => planner.distances = None,
            Some((_, cell)) => self.cell = cell,
            None => {}
        }
    }
}

activation_tree! {
    struct Warehouse { root: Cart, cycle_hz: 50, components: [Cart, Planner, Map] }
}

fn main() {
    let (mut warehouse, mut cell) = (Warehouse::new(), 0);
    for cycle in 0..500 {
        warehouse.tick(Instant::from_millis(20 * cycle));
        if cycle == 100 {
            println!("      a box falls into the aisle");
            warehouse.get_mut::<Map>().grid.0[2 * WIDTH + 5] = true;
        }
        let now = warehouse.get::<Cart>().cell;
        if std::mem::replace(&mut cell, now) != now {
            println!("{:4.1} s row {}, column {}", 0.02 * cycle as f32, now / WIDTH, now % WIDTH);
        }
    }
    assert_eq!(cell, warehouse.get::<Planner>().goal, "the cart has arrived");
}
