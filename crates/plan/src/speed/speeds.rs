//! The speeds of a vector.

/// The speeds of a vector, in mm/s, and its duration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::struct_field_names, reason = "units")]
pub(crate) struct Speeds {
    pub start_mm_s: f64,
    pub end_mm_s: f64,
    pub max_mm_s: f64,
    /// The peak speed that is reached.
    pub peak_mm_s: f64,
    /// The maximum speed that is allowed.
    pub limit_mm_s: f64,
    pub duration_s: f64,
}

impl Speeds {
    /// Creates the speeds of a vector from start, end and maximum speed, in mm/s.
    pub(crate) fn of(length_mm: f64, speeds: [f64; 3], limit_mm_s: f64, acceleration: f64) -> Self {
        let [start_mm_s, end_mm_s, max_mm_s] = speeds;
        let peak_mm_s = peak_mm_s(length_mm, speeds, acceleration);
        let ends_v2 = start_mm_s * start_mm_s + end_mm_s * end_mm_s;
        let ramps_mm = (peak_mm_s * peak_mm_s - 0.5 * ends_v2) / acceleration;
        let ramps_s = (2.0 * peak_mm_s - start_mm_s - end_mm_s) / acceleration;
        Self {
            start_mm_s,
            end_mm_s,
            max_mm_s,
            peak_mm_s,
            limit_mm_s,
            duration_s: ramps_s + (length_mm - ramps_mm).max(0.0) / peak_mm_s,
        }
    }

    /// Returns the ramps of a vector of this length.
    pub(crate) fn ramps(&self, length_mm: f64, acceleration: f64) -> Ramps {
        let (start, end, peak) = (self.start_mm_s, self.end_mm_s, self.peak_mm_s);
        let up_s = (peak - start) / acceleration;
        let up_mm = 0.5 * (start + peak) * up_s;
        let down_mm = 0.5 * (end + peak) * (peak - end) / acceleration;
        Ramps {
            start_mm_s: start,
            peak_mm_s: peak,
            acceleration,
            up_s,
            up_mm,
            even_s: (length_mm - up_mm - down_mm).max(0.0) / peak,
        }
    }
}

/// The execution of a vector: acceleration, constant speed and braking.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ramps {
    start_mm_s: f64,
    peak_mm_s: f64,
    acceleration: f64,
    /// The duration and distance of the acceleration, in s and mm.
    up_s: f64,
    up_mm: f64,
    /// The duration of constant speed, in s.
    even_s: f64,
}

impl Ramps {
    /// Returns the distance along the vector at a time, in mm.
    pub(crate) fn distance_mm(&self, t_s: f64) -> f64 {
        let (peak, a) = (self.peak_mm_s, self.acceleration);
        if t_s <= self.up_s {
            return (self.start_mm_s + 0.5 * a * t_s) * t_s;
        }
        let even_s = t_s - self.up_s;
        if even_s <= self.even_s {
            return self.up_mm + peak * even_s;
        }
        let braking_s = even_s - self.even_s;
        self.up_mm + peak * self.even_s + (peak - 0.5 * a * braking_s) * braking_s
    }

    /// Returns the time at a distance along the vector, in s.
    pub(crate) fn reached_s(&self, covered_mm: f64) -> f64 {
        let (start, peak, a) = (self.start_mm_s, self.peak_mm_s, self.acceleration);
        if covered_mm <= self.up_mm {
            return ((start * start + 2.0 * a * covered_mm).sqrt() - start) / a;
        }
        let even_mm = covered_mm - self.up_mm;
        if even_mm <= peak * self.even_s {
            return self.up_s + even_mm / peak;
        }
        let braking_mm = even_mm - peak * self.even_s;
        let speed_mm_s = (peak * peak - 2.0 * a * braking_mm).max(0.0).sqrt();
        self.up_s + self.even_s + (peak - speed_mm_s) / a
    }
}

fn peak_mm_s(length_mm: f64, [start, end, max]: [f64; 3], a: f64) -> f64 {
    let meet_v2 = 0.5 * (start * start + end * end) + a * length_mm;
    max.min(meet_v2.sqrt()).max(start).max(end)
}
