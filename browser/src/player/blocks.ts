// Blocks of numbers as a shared file holds them: differences of neighbours, byte plane by byte plane (decision 63).

export interface BlockPlace {
  at: number
  type: 'f8' | 'f4' | 'bytes'
  rows: number
  columns: number
}

const SIZE = { f8: 8, f4: 4, bytes: 1 }

export class Blocks {
  private readonly made = new Map<number, Float64Array[] | Float32Array[]>()

  constructor(
    private readonly places: readonly BlockPlace[],
    private readonly content: Uint8Array<ArrayBuffer>,
  ) {}

  /** The rows of a block of double precision. */
  doubles(number: number): Float64Array[] {
    return this.rows(number, 'f8', (bits) => new Float64Array(bits)) as Float64Array[]
  }

  /** The rows of a block of single precision. */
  floats(number: number): Float32Array[] {
    return this.rows(number, 'f4', (bits) => new Float32Array(bits)) as Float32Array[]
  }

  /** Bytes as they were put in. */
  bytes(number: number): ArrayBuffer {
    const { at, columns } = this.place(number, 'bytes')
    return this.content.slice(at, at + columns).buffer
  }

  private rows<Row extends Float64Array | Float32Array>(
    number: number,
    type: 'f8' | 'f4',
    row: (bits: ArrayBuffer) => Row,
  ): unknown {
    const before = this.made.get(number)
    if (before) return before
    const { at, rows, columns } = this.place(number, type)
    const all = unpacked(this.content.subarray(at, at + rows * columns * SIZE[type]), SIZE[type], columns)
    const width = columns * SIZE[type]
    const made = Array.from({ length: rows }, (_, k) => row(all.buffer.slice(k * width, (k + 1) * width)))
    this.made.set(number, made as Float64Array[] | Float32Array[])
    return made
  }

  private place(number: number, type: BlockPlace['type']): BlockPlace {
    const place = this.places[number]
    if (place?.type !== type) throw new Error(`expected a block of ${type}, found ${place?.type ?? 'none'}`)
    return place
  }
}

/** Byte planes as whole numbers again, each the sum of what stands before it in its row. */
export function unpacked(planes: Uint8Array, size: number, columns: number): Uint8Array<ArrayBuffer> {
  const count = planes.length / size
  const bytes = new Uint8Array(planes.length)
  for (let k = 0; k < count; k += 1) {
    const isFirst = k % columns === 0
    let carry = 0
    for (let byte = 0; byte < size; byte += 1) {
      const sum = planes[byte * count + k]! + (isFirst ? 0 : bytes[(k - 1) * size + byte]!) + carry
      bytes[k * size + byte] = sum & 255
      carry = sum >> 8
    }
  }
  return bytes
}
