// Things of the page as files of the user's.

/** Hand the browser a file to save. */
export function save(name: string, content: Blob): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name.replaceAll('/', '_')
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}

/** A drawing with its title on the ground it stands on. */
export async function toPng(drawing: HTMLCanvasElement, title: string, place: HTMLElement): Promise<Blob> {
  const head = 26 * devicePixelRatio
  const canvas = Object.assign(document.createElement('canvas'), {
    width: drawing.width,
    height: drawing.height + head,
  })
  const pen = canvas.getContext('2d')
  if (!pen) throw new Error('a canvas without a context')
  const style = getComputedStyle(place.parentElement ?? place)
  pen.fillStyle = style.backgroundColor
  pen.fillRect(0, 0, canvas.width, canvas.height)
  pen.fillStyle = style.color
  pen.font = `600 ${12 * devicePixelRatio}px ${style.fontFamily}`
  pen.fillText(title, 8 * devicePixelRatio, 17 * devicePixelRatio)
  pen.drawImage(drawing, 0, head)
  return new Promise((done, failed) =>
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error('no picture came'))), 'image/png'),
  )
}
