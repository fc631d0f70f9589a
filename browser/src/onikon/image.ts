// Pictures of digits as images, and images as pictures.
import { PALETTE, rgbOf } from '../geom/palette'
import { fromRgba, sizeOf, type Picture, type Size } from '../geom/pixels'

const COLOURS = PALETTE.map((colour) => rgbOf(colour.hex))
const LARGEST = 600 // pixels of an imported image on its longer side; more says nothing in 62 cells
const made = new Map<Picture, string>()

/** Draw a picture, one pixel for each digit. */
export function draw(canvas: HTMLCanvasElement, picture: Picture): void {
  const pen = canvas.getContext('2d')
  if (!pen) return
  const size = sizeOf(picture)
  const image = pen.createImageData(size, size)
  for (let k = 0; k < picture.length; k += 1) {
    image.data.set(COLOURS[Number(picture[k])] ?? COLOURS[8], 4 * k)
    image.data[4 * k + 3] = 255
  }
  pen.putImageData(image, 0, 0)
}

/** The address of a picture as an image; made once for each. */
export function imageUrl(picture: Picture): string {
  let url = made.get(picture)
  if (!url) {
    const size = sizeOf(picture)
    const canvas = Object.assign(document.createElement('canvas'), { width: size, height: size })
    draw(canvas, picture)
    url = canvas.toDataURL()
    if (made.size > 4000) made.clear() // a picture being drawn makes many, and so do dictionaries of a thousand icons
    made.set(picture, url)
  }
  return url
}

/** How a browser scales it: sharp where each cell is a whole number of pixels, else smooth, so that no row is lost. */
export const rendering = (picture: Picture, pixels: number): 'pixelated' | 'auto' =>
  pixels % sizeOf(picture) === 0 ? 'pixelated' : 'auto'

/** An image file as a picture of so many cells; rejects where the browser cannot read it. */
export async function imported(file: Blob, size: Size): Promise<Picture> {
  const bitmap = await createImageBitmap(file)
  const scale = Math.min(1, LARGEST / Math.max(bitmap.width, bitmap.height))
  const [width, height] = [
    Math.max(1, Math.round(bitmap.width * scale)),
    Math.max(1, Math.round(bitmap.height * scale)),
  ]
  const pen = new OffscreenCanvas(width, height).getContext('2d')
  if (!pen) throw new Error('a canvas without a context')
  pen.drawImage(bitmap, 0, 0, width, height)
  return fromRgba(pen.getImageData(0, 0, width, height).data, width, height, size)
}
