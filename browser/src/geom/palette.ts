/** The nine colours of pictures (§5.6.1). */

export interface Colour {
  readonly name: string
  readonly hex: string
}

/** By the digit that stands for each in a picture. */
export const PALETTE: readonly Colour[] = [
  { name: 'red', hex: '#d8402f' },
  { name: 'green', hex: '#2a9d5c' },
  { name: 'blue', hex: '#2b62c4' },
  { name: 'yellow', hex: '#f4c93c' },
  { name: 'orange', hex: '#ee8a2c' },
  { name: 'purple', hex: '#8a5cc4' },
  { name: 'grey', hex: '#9a9fa5' },
  { name: 'white', hex: '#fbfaf5' },
  { name: 'black', hex: '#16181b' },
]

export type Rgb = readonly [number, number, number]

export function rgbOf(hex: string): Rgb {
  const n = parseInt(hex.slice(1), 16)
  return [n >> 16, (n >> 8) & 255, n & 255]
}

/** Whether a colour is none: a grey, or nearly so. */
export function isGrey(hex: string): boolean {
  const [r, g, b] = rgbOf(hex)
  return Math.max(r, g, b) - Math.min(r, g, b) < 32
}

/** The digit of the colour that looks most like this one. */
export function nearestDigit([r, g, b]: Rgb, palette: readonly Rgb[]): string {
  let [best, least] = [0, Infinity]
  palette.forEach(([pr, pg, pb], k) => {
    // Weighted by how much the eye makes of each: a cheap stand-in for a distance of perception.
    const red = (r + pr) / 2
    const d = (2 + red / 256) * (r - pr) ** 2 + 4 * (g - pg) ** 2 + (2 + (255 - red) / 256) * (b - pb) ** 2
    if (d < least) [best, least] = [k, d]
  })
  return String(best)
}
