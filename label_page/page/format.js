/// Formats a time as 1:02:03.4, with `digits` after the point.
export function clock(seconds, digits = 1) {
  const scale = 10 ** digits;
  const whole = Math.round(Math.max(0, seconds) * scale);
  const rest = whole % (60 * scale), minutes = Math.floor(whole / (60 * scale));
  const text = (rest / scale).toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  const hours = Math.floor(minutes / 60);
  return hours ? `${hours}:${String(minutes % 60).padStart(2, "0")}:${text}` : `${minutes}:${text}`;
}

/// Formats a duration: 0.4 s, 12 s, 3 min.
export function length(seconds) {
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  return seconds < 120 ? `${seconds.toFixed(0)} s` : `${(seconds / 60).toFixed(0)} min`;
}

/// Returns the smallest round step (1, 2, 5, 10, 15, 30 s, 1 min, ...) of at least `least` s.
export function niceStep(least) {
  const steps = [.05, .1, .2, .5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200];
  return steps.find(step => step >= least) ?? 14400;
}
