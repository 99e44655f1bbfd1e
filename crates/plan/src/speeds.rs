//! The speeds of one vector.

/// The speeds of one vector, in mm/s, and how long it takes with them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::struct_field_names, reason = "units")]
pub(super) struct Speeds {
    pub start_mm_s: f64,
    pub end_mm_s: f64,
    pub max_mm_s: f64,
    /// The largest speed that is reached.
    pub peak_mm_s: f64,
    /// The largest that would be allowed.
    pub limit_mm_s: f64,
    pub duration_s: f64,
}

impl Speeds {
    /// A vector with these speeds: at its start, at its end, and the largest, in mm/s.
    pub(super) fn of(length_mm: f64, speeds: [f64; 3], limit_mm_s: f64, acceleration: f64) -> Self {
        let [start_mm_s, end_mm_s, max_mm_s] = speeds;
        Self {
            start_mm_s,
            end_mm_s,
            max_mm_s,
            peak_mm_s: peak_mm_s(length_mm, speeds, acceleration),
            limit_mm_s,
            duration_s: duration_s(length_mm, speeds, acceleration),
        }
    }

    /// How far along the vector the tool is after a time, with these speeds.
    pub(super) fn distance_mm(&self, length_mm: f64, a: f64, t_s: f64) -> f64 {
        let (start, end, peak) = (self.start_mm_s, self.end_mm_s, self.peak_mm_s);
        let up_s = (peak - start) / a;
        if t_s <= up_s {
            return (start + 0.5 * a * t_s) * t_s;
        }
        let up_mm = 0.5 * (start + peak) * up_s;
        let down_mm = 0.5 * (end + peak) * (peak - end) / a;
        let even_s = (length_mm - up_mm - down_mm).max(0.0) / peak;
        if t_s <= up_s + even_s {
            return up_mm + peak * (t_s - up_s);
        }
        let braking_s = t_s - up_s - even_s;
        up_mm + peak * even_s + (peak - 0.5 * a * braking_s) * braking_s
    }

    /// After which time the tool is so far along the vector, in s.
    pub(super) fn reached_s(&self, length_mm: f64, a: f64, gone_mm: f64) -> f64 {
        let (start, end, peak) = (self.start_mm_s, self.end_mm_s, self.peak_mm_s);
        let up_s = (peak - start) / a;
        let up_mm = 0.5 * (start + peak) * up_s;
        if gone_mm <= up_mm {
            return ((start * start + 2.0 * a * gone_mm).sqrt() - start) / a;
        }
        let down_mm = 0.5 * (end + peak) * (peak - end) / a;
        let even_mm = (length_mm - up_mm - down_mm).max(0.0);
        if gone_mm <= up_mm + even_mm {
            return up_s + (gone_mm - up_mm) / peak;
        }
        let braking_mm = gone_mm - up_mm - even_mm;
        let speed_mm_s = (peak * peak - 2.0 * a * braking_mm).max(0.0).sqrt();
        up_s + even_mm / peak + (peak - speed_mm_s) / a
    }
}

fn duration_s(length_mm: f64, [start, end, max]: [f64; 3], a: f64) -> f64 {
    let peak = peak_mm_s(length_mm, [start, end, max], a);
    let ramps_mm = (peak * peak - 0.5 * (start * start + end * end)) / a;
    (2.0 * peak - start - end) / a + (length_mm - ramps_mm).max(0.0) / peak
}

fn peak_mm_s(length_mm: f64, [start, end, max]: [f64; 3], a: f64) -> f64 {
    let meet_v2 = 0.5 * (start * start + end * end) + a * length_mm;
    max.min(meet_v2.sqrt()).max(start).max(end)
}
