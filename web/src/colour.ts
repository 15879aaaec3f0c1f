// Tension as colour: slack is blue, the largest of the picture red. The same steps as in the report.
const steps = [
  [111, 143, 179], [79, 134, 192], [42, 157, 143], [119, 166, 60], [201, 162, 39], [224, 123, 26], [209, 73, 26], [163, 18, 43],
] as const;

export function tensionRgb(tension: number, least: number, most: number): [number, number, number] {
  const share = most > least ? Math.min(Math.max((tension - least) / (most - least), 0), 1) : 0;
  const at = share * (steps.length - 1);
  const low = Math.min(Math.floor(at), steps.length - 2);
  const mix = at - low;
  const a = steps[low]!;
  const b = steps[low + 1]!;
  return [0, 1, 2].map((i) => Math.round(a[i]! + mix * (b[i]! - a[i]!))) as [number, number, number];
}

export function tensionColour(tension: number, least: number, most: number): string {
  return `rgb(${tensionRgb(tension, least, most).join(' ')})`;
}
