// Twin of lookup.rs. A table is a 2D array texture: x is φ_d, y is θ_d, the layer is θ_h; alpha is 1 where measured.

const THETA_BINS: i32 = 90;

fn table_cell(table: texture_2d_array<f32>, bins: vec3i) -> vec4f {
    return textureLoad(table, vec2i(bins.z, bins.y), bins.x, 0);
}

// Bin coordinates (θ_h, θ_d, φ_d) such that bin i covers [i, i+1).
fn bin_coordinates(angles: HalfDiff, phi_bins: i32) -> vec3f {
    return vec3f(
        f32(THETA_BINS) * sqrt(angles.theta_h / (0.5 * PI)),
        degrees(angles.theta_d),
        degrees(wrap(angles.phi_d, select(TAU, PI, phi_bins == 180))),
    );
}

fn bins_of(u: vec3f, phi_bins: i32) -> vec3i {
    return min(vec3i(u), vec3i(THETA_BINS - 1, THETA_BINS - 1, phi_bins - 1));
}

// The cell that holds the angles. Alpha is 0 where there is no value.
fn lookup_nearest(table: texture_2d_array<f32>, angles: HalfDiff) -> vec4f {
    let phi_bins = i32(textureDimensions(table).x);
    return table_cell(table, bins_of(bin_coordinates(angles, phi_bins), phi_bins));
}

// Trilinear between bin centres over the valid neighbours; no value where the cell that holds the angles has none.
fn lookup_smooth(table: texture_2d_array<f32>, angles: HalfDiff) -> vec4f {
    let phi_bins = i32(textureDimensions(table).x);
    let u = bin_coordinates(angles, phi_bins);
    if table_cell(table, bins_of(u, phi_bins)).a == 0.0 {
        return vec4f(0.0);
    }
    let last = f32(THETA_BINS - 1);
    let at = vec3f(clamp(u.xy - 0.5, vec2f(0.0), vec2f(last)), u.z - 0.5);
    let low = floor(at);
    let fraction = at - low;
    var sum = vec4f(0.0);
    for (var corner = 0; corner < 8; corner++) {
        let step = vec3i(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
        let weights = select(1.0 - fraction, fraction, step == vec3i(1));
        var bins = vec3i(low) + step;
        bins = vec3i(min(bins.xy, vec2i(THETA_BINS - 1)), (bins.z + phi_bins) % phi_bins);
        let cell = table_cell(table, bins);
        sum += weights.x * weights.y * weights.z * cell.a * vec4f(cell.rgb, 1.0);
    }
    // The cell that holds the angles has a weight of at least 1/8.
    return vec4f(sum.rgb / sum.a, 1.0);
}

fn lookup_table(table: texture_2d_array<f32>, smoothly: bool, wi: vec3f, wo: vec3f) -> vec4f {
    let sum = wi + wo;
    if wi.z < 0.0 || wo.z < 0.0 || dot(sum, sum) < 1e-30 {
        return vec4f(0.0);
    }
    let angles = half_diff_from_directions(wi, wo);
    if smoothly {
        return lookup_smooth(table, angles);
    }
    return lookup_nearest(table, angles);
}
