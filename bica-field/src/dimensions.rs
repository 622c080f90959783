//! Lengths of a field.

use glam::Vec2;

/// Lengths of a field, its goals and its ball, mm, as the rules state them.
///
/// Whole millimetres keep derived lengths exact: each length in metres is the `f32` nearest to its decimal value.
/// Lengths between lines and between posts are measured from centre to centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FieldDimensions {
    /// Length of the side lines.
    pub field_length_mm: u16,
    /// Length of the goal lines.
    pub field_width_mm: u16,
    /// Width of the carpet outside the lines, to each side.
    pub border_strip_width_mm: u16,
    /// Width of all lines.
    pub line_width_mm: u16,
    /// Extent of the penalty areas along x.
    pub penalty_area_length_mm: u16,
    /// Extent of the penalty areas along y.
    pub penalty_area_width_mm: u16,
    /// Distance of the penalty marks from the goal lines.
    pub penalty_mark_distance_mm: u16,
    /// Extent of the penalty marks and of the centre mark, which are plus signs.
    pub penalty_mark_size_mm: u16,
    /// Diameter of the centre circle.
    pub centre_circle_diameter_mm: u16,
    /// Distance between the two posts of a goal.
    pub goal_width_mm: u16,
    /// Distance of the posts from the goal line, outwards.
    pub goal_post_offset_mm: u16,
    /// Distance from the goal line to the back of the goal.
    pub goal_depth_mm: u16,
    /// Height of the goals, crossbar included.
    pub goal_height_mm: u16,
    /// Diameter of the posts.
    pub post_diameter_mm: u16,
    /// Diameter of the crossbars.
    pub crossbar_diameter_mm: u16,
    /// Height and depth of the triangular panels at the sides of the goals.
    pub goal_panel_mm: u16,
    /// Distance of the throw-in lines from the side lines, inwards.
    pub throw_in_distance_mm: u16,
    /// Distance of the ends of the throw-in lines from the goal lines.
    pub throw_in_end_mm: u16,
    /// Diameter of the ball.
    pub ball_diameter_mm: u16,
}

/// The field of the RoboCup Standard Platform League in 2009.
///
/// Sources: rules of 2009; centres of lines and posts from the `field.cfg` of B-Human 2009; the ball's diameter from the
/// rules of 2010, a street-hockey ball.
pub const SPL_2009: FieldDimensions = FieldDimensions {
    field_length_mm: 6000,
    field_width_mm: 4000,
    border_strip_width_mm: 700,
    line_width_mm: 50,
    penalty_area_length_mm: 600,
    penalty_area_width_mm: 3000,
    penalty_mark_distance_mm: 1800,
    penalty_mark_size_mm: 100,
    centre_circle_diameter_mm: 1200,
    goal_width_mm: 1400,
    goal_post_offset_mm: 50,
    goal_depth_mm: 500,
    goal_height_mm: 800,
    post_diameter_mm: 100,
    crossbar_diameter_mm: 50,
    goal_panel_mm: 400,
    throw_in_distance_mm: 400,
    throw_in_end_mm: 1000,
    ball_diameter_mm: 65,
};

/// Field for which this workspace is built: vision, simulation, player and tools.
///
/// Programs for another field change this value.
pub const FIELD: FieldDimensions = SPL_2009;

/// Converts a length from millimetres to metres. The division rounds once, to the nearest `f32`.
const fn metres(millimetres: u16) -> f32 {
    millimetres as f32 / 1000.0
}

/// Half of a length in millimetres, m.
const fn half(millimetres: u16) -> f32 {
    millimetres as f32 / 2000.0
}

/// Derived points and lengths: field frame, m, at positive coordinates.
impl FieldDimensions {
    /// Corner of the carpet.
    #[must_use]
    #[inline]
    pub const fn carpet_corner(&self) -> Vec2 {
        let border = 2 * self.border_strip_width_mm;
        Vec2::new(half(self.field_length_mm + border), half(self.field_width_mm + border))
    }

    /// Corner of side line and goal line.
    #[must_use]
    #[inline]
    pub const fn field_corner(&self) -> Vec2 {
        Vec2::new(half(self.field_length_mm), half(self.field_width_mm))
    }

    /// Corner of a penalty area's lines, the one away from the goal line.
    #[must_use]
    #[inline]
    pub const fn penalty_area_corner(&self) -> Vec2 {
        Vec2::new(half(self.field_length_mm - 2 * self.penalty_area_length_mm), half(self.penalty_area_width_mm))
    }

    /// Width of a line.
    #[must_use]
    #[inline]
    pub const fn line_width(&self) -> f32 {
        metres(self.line_width_mm)
    }

    /// Radius of the centre circle, at the middle of its line.
    #[must_use]
    #[inline]
    pub const fn centre_circle_radius(&self) -> f32 {
        half(self.centre_circle_diameter_mm)
    }

    /// Distance of a penalty mark from the centre mark, along x.
    #[must_use]
    #[inline]
    pub const fn penalty_mark(&self) -> f32 {
        half(self.field_length_mm - 2 * self.penalty_mark_distance_mm)
    }

    /// Length of the two bars of a penalty mark or of the centre mark.
    #[must_use]
    #[inline]
    pub const fn penalty_mark_size(&self) -> f32 {
        metres(self.penalty_mark_size_mm)
    }

    /// Foot of a goal post.
    #[must_use]
    #[inline]
    pub const fn goal_post(&self) -> Vec2 {
        Vec2::new(half(self.field_length_mm + 2 * self.goal_post_offset_mm), half(self.goal_width_mm))
    }

    /// Feet of a goal's posts, of the attacked goal or of the own one: the left post first, as seen from the field.
    #[must_use]
    #[inline]
    pub const fn goal_posts(&self, attacked: bool) -> [Vec2; 2] {
        let post = self.goal_post();
        let (x, y) = if attacked { (post.x, post.y) } else { (-post.x, -post.y) };
        [Vec2::new(x, y), Vec2::new(x, -y)]
    }

    /// Distance between a goal's posts.
    #[must_use]
    #[inline]
    pub const fn goal_width(&self) -> f32 {
        metres(self.goal_width_mm)
    }

    /// Height of a goal, crossbar included.
    #[must_use]
    #[inline]
    pub const fn goal_height(&self) -> f32 {
        metres(self.goal_height_mm)
    }

    /// Distance of a goal's back from the centre mark, along x, on the ground.
    #[must_use]
    #[inline]
    pub const fn goal_back(&self) -> f32 {
        half(self.field_length_mm + 2 * self.goal_depth_mm)
    }

    /// Height and depth of the triangular panels at a goal's sides.
    #[must_use]
    #[inline]
    pub const fn goal_panel(&self) -> f32 {
        metres(self.goal_panel_mm)
    }

    /// Diameter of a post.
    #[must_use]
    #[inline]
    pub const fn post_diameter(&self) -> f32 {
        metres(self.post_diameter_mm)
    }

    /// Radius of a post.
    #[must_use]
    #[inline]
    pub const fn post_radius(&self) -> f32 {
        half(self.post_diameter_mm)
    }

    /// Radius of a crossbar.
    #[must_use]
    #[inline]
    pub const fn crossbar_radius(&self) -> f32 {
        half(self.crossbar_diameter_mm)
    }

    /// End of a throw-in line, on which a ball that left the field is put back.
    #[must_use]
    #[inline]
    pub const fn throw_in_corner(&self) -> Vec2 {
        Vec2::new(
            half(self.field_length_mm - 2 * self.throw_in_end_mm),
            half(self.field_width_mm - 2 * self.throw_in_distance_mm),
        )
    }

    /// Radius of the ball.
    #[must_use]
    #[inline]
    pub const fn ball_radius(&self) -> f32 {
        half(self.ball_diameter_mm)
    }
}
