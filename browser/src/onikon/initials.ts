// A picture to begin with: the initials of a name, until somebody draws a better one.
import { blank, BLACK, SIZE, type Picture } from '../geom/pixels'

const INNER = SIZE - 2
const INK = '2' // blue, as the things of the laboratory are
const DARK = 110

/** The first letters of the first two words of a name; digits count as they are. */
export function initialsOf(name: string): string {
  const words = name.split(/[^\p{L}\p{N}]+|(?<=\p{Ll})(?=\p{Lu})/u).filter(Boolean)
  return words
    .slice(0, 2)
    .map((word) => [...word][0]!.toUpperCase())
    .join('')
}

/** Letters in the middle of a picture; without any, the blank one. */
export function lettered(letters: string): Picture {
  const pen = new OffscreenCanvas(INNER, INNER).getContext('2d', { willReadFrequently: true })
  if (!pen || !letters) return blank()
  pen.font = `bold ${letters.length > 1 ? 17 : 24}px sans-serif`
  pen.textAlign = 'center'
  pen.textBaseline = 'alphabetic'
  const { actualBoundingBoxAscent: up, actualBoundingBoxDescent: down } = pen.measureText(letters)
  pen.fillText(letters, INNER / 2, Math.round((INNER + up - down) / 2), INNER - 2)
  const { data } = pen.getImageData(0, 0, INNER, INNER)
  return [...blank()].map((digit, k) => (digit === BLACK || !isInked(data, k) ? digit : INK)).join('')
}

function isInked(data: Uint8ClampedArray, k: number): boolean {
  const [x, y] = [(k % SIZE) - 1, Math.floor(k / SIZE) - 1]
  return data[4 * (y * INNER + x) + 3]! > DARK
}
