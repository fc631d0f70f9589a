// A quantity over frequency on a logarithmic axis, drawn by uPlot: what is reliable as a line, all of it pale behind.
import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import { number } from '../values/compact'
import { inks } from '../values/inks'

const TONES = ['--ink-3', '--line', '--accent', '--p1', '--panel'] as const

export interface BodeCurve {
  hertz: readonly number[]
  values: readonly number[]
  isReliable: readonly boolean[]
  /** Frequencies with a line across, and what stands beside it. */
  marks: readonly { hertz: number; text: string }[]
}

export class BodeChart {
  private readonly plot: uPlot
  private readonly tones: Record<(typeof TONES)[number], string>
  private readonly mono: string
  private curve: BodeCurve = { hertz: [], values: [], isReliable: [], marks: [] }

  /** Charts of one `group` show the frequency under the pointer together. */
  constructor(
    place: HTMLElement,
    private readonly unit: string,
    private readonly group: string,
  ) {
    this.tones = inks(place, TONES)
    this.mono = getComputedStyle(place).getPropertyValue('--mono') || 'monospace'
    this.plot = new uPlot(this.options(place), [[], [], []], place)
  }

  /** Fills its place, until what is given back is called: then it is gone. */
  fill(place: HTMLElement): () => void {
    const room = new ResizeObserver(() =>
      this.plot.setSize({ width: Math.max(120, place.clientWidth), height: Math.max(60, place.clientHeight) }),
    )
    room.observe(place)
    return () => {
      room.disconnect()
      this.plot.destroy()
    }
  }

  show(curve: BodeCurve): void {
    this.curve = curve
    const sure = curve.values.map((value, k) => (curve.isReliable[k] ? value : null))
    this.plot.setData([[...curve.hertz], [...curve.values], sure])
  }

  private options(place: HTMLElement): uPlot.Options {
    const { tones } = this
    const font = `9.5px ${this.mono}`
    const axis = { stroke: tones['--ink-3'], font, ticks: { show: false }, border: { show: false } }
    const grid = { stroke: tones['--line'], width: 1 }
    const minus = (value: number): string => String(Math.round(value * 1e6) / 1e6).replaceAll('-', '−')
    const points = { show: false }
    return {
      width: place.clientWidth || 300,
      height: place.clientHeight || 120,
      legend: { show: false },
      padding: [8, 62, 0, 0],
      cursor: { y: false, drag: { x: false, y: false }, sync: { key: this.group }, points: { size: 6 } },
      scales: { x: { time: false, distr: 3, log: 10, range: (_, low, high) => [low, high] } },
      axes: [
        {
          ...axis,
          size: 20,
          gap: 4,
          space: 34,
          grid,
          splits: (_, __, low, high) => lines(low, high),
          filter: (_, all) => all,
          values: (_, all) => all.map((at) => (isNamed(at) ? `${minus(at)} Hz` : '')),
        },
        { ...axis, size: 62, gap: 5, space: 24, grid, values: (_, all) => all.map((v) => `${minus(v)} ${this.unit}`) },
      ],
      series: [
        {},
        { stroke: tones['--p1'], width: 1, alpha: 0.4, dash: [2, 3], points },
        { stroke: tones['--p1'], width: 1.75, points },
      ],
      hooks: { draw: [() => this.drawMarks()], setCursor: [(plot) => plot.redraw(false, false)] },
    }
  }

  /** Lines across with their words, and beside the chart the value under the pointer. */
  private drawMarks(): void {
    const { ctx, bbox, scales, cursor } = this.plot
    const ratio = devicePixelRatio
    const { hertz, values, marks } = this.curve
    ctx.save()
    ctx.font = `600 ${10 * ratio}px ${this.mono}`
    ctx.textBaseline = 'alphabetic'
    ctx.lineWidth = ratio
    ctx.setLineDash([4 * ratio, 3 * ratio])
    for (const mark of marks) {
      if (!(mark.hertz >= (scales.x?.min ?? 0) && mark.hertz <= (scales.x?.max ?? 0))) continue
      const x = Math.round(this.plot.valToPos(mark.hertz, 'x', true))
      ctx.strokeStyle = ctx.fillStyle = this.tones['--accent']
      ctx.beginPath()
      ctx.moveTo(x, bbox.top)
      ctx.lineTo(x, bbox.top + bbox.height)
      ctx.stroke()
      const isLeft = x + 5 * ratio + ctx.measureText(mark.text).width > bbox.left + bbox.width
      ctx.textAlign = isLeft ? 'right' : 'left'
      ctx.fillText(mark.text, x + (isLeft ? -5 : 5) * ratio, bbox.top + bbox.height - 5 * ratio)
    }
    const at = cursor.idx
    if (at !== null && at !== undefined && hertz[at] !== undefined) {
      ctx.textAlign = 'left'
      ctx.fillStyle = this.tones['--p1']
      ctx.fillText(`${number(values[at]!)} ${this.unit}`, bbox.left + bbox.width + 5 * ratio, bbox.top + 10 * ratio)
      ctx.fillStyle = this.tones['--ink-3']
      ctx.fillText(`${number(hertz[at])} Hz`, bbox.left + bbox.width + 5 * ratio, bbox.top + 22 * ratio)
    }
    ctx.restore()
  }
}

/** 1 to 9 times each power of ten between two frequencies. */
function lines(low: number, high: number): number[] {
  const first = Math.floor(Math.log10(low))
  const decades = Array.from({ length: Math.ceil(Math.log10(high)) - first + 1 }, (_, k) => 10 ** (first + k))
  const all = decades.flatMap((power) => Array.from({ length: 9 }, (_, k) => (k + 1) * power))
  return all.filter((hertz) => hertz >= low * (1 - 1e-9) && hertz <= high * (1 + 1e-9))
}

/** Of the lines of a logarithmic axis 1, 2 and 5 of each decade have their numbers. */
function isNamed(hertz: number): boolean {
  const first = Math.round(hertz / 10 ** Math.floor(Math.log10(hertz) + 1e-9))
  return first === 1 || first === 2 || first === 5
}
