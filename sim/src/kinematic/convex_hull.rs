//! Convex hulls in the plane.

use glam::Vec2;

/// Returns the convex hull of points, counter-clockwise where y is left of x (Andrew's monotone chain, 1979).
pub(crate) fn convex_hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut chain: Vec<Vec2> = Vec::with_capacity(points.len() + 1);
    let mut add = |point: Vec2, least: usize| {
        while chain.len() > least {
            let [a, b] = [chain[chain.len() - 2], chain[chain.len() - 1]];
            if (b - a).perp_dot(point - a) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
        chain.len()
    };
    let mut length = 0;
    for &point in &points {
        length = add(point, 1);
    }
    for &point in points.iter().rev().skip(1) {
        add(point, length);
    }
    if chain.len() > 1 {
        chain.pop();
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, Stream};

    #[test]
    fn hull_is_convex_and_contains_all_points() {
        let mut random = Random::new(2, Stream::Start);
        for count in 3..40 {
            let points: Vec<Vec2> = (0..count).map(|_| Vec2::new(random.unit(), random.unit())).collect();
            let found = convex_hull(points.clone());
            assert!(found.iter().all(|corner| points.contains(corner)));
            for (i, &a) in found.iter().enumerate() {
                let b = found[(i + 1) % found.len()];
                assert!(points.iter().all(|&point| (b - a).perp_dot(point - a) >= -1e-6));
            }
        }
    }

    #[test]
    fn hull_of_one_point_is_that_point() {
        assert!(convex_hull(Vec::new()).is_empty());
        assert_eq!(convex_hull(vec![Vec2::X]), [Vec2::X]);
        assert_eq!(convex_hull(vec![Vec2::X, Vec2::X, Vec2::X]).len(), 1);
    }
}
