// Lines of a variable over time, drawn by uPlot; nothing here knows where the numbers come from.
import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import { number } from '../values/compact'
import { dash, hue, HUES, inks } from '../values/inks'
import { limits } from './limits'
import type { Mark } from '../values/marks'
import type { Stretch } from '../values/series'
import { spread } from './spread'

const TONES = [
  '--ink-3',
  '--line',
  '--error',
  '--error-ink',
  '--waiting',
  '--on-ink',
  '--ink-2',
  '--accent',
  '--panel',
  ...HUES,
] as const
const SMALL = '9.5px'
const NAMES_WIDTH = 62
const NAME_GAP = 12

export interface Hands {
  /** A stretch of time was dragged over. */
  pick(from_s: number, to_s: number): void
  /** The wheel was turned over a time. */
  wheel(at_s: number, notches: number): void
  reset(): void
  /** A time was clicked. */
  go?(at_s: number): void
}

export class Chart {
  private readonly plot: uPlot
  private readonly tones: Record<(typeof TONES)[number], string>
  private readonly mono: string
  private readonly sans: string
  private marks: readonly Mark[] = []
  private former: [number, number] | undefined
  private shown: { stretch: Stretch; from_s: number; to_s: number } | undefined
  /** The instant that is looked at; NaN: it is no recorded run. */
  private at_s = NaN

  /**
   * `elements` are those drawn, `names` what stands beside their lines. Elements from `width` on are those of a second run,
   * drawn pale behind their likes.
   */
  constructor(
    place: HTMLElement,
    private readonly elements: readonly number[],
    private readonly names: readonly string[],
    hands: Hands,
    private readonly width = Infinity,
  ) {
    this.tones = inks(place, TONES)
    const style = getComputedStyle(place)
    this.mono = style.getPropertyValue('--mono') || 'monospace'
    this.sans = style.getPropertyValue('--sans') || 'sans-serif'
    this.plot = new uPlot(this.options(place, hands), [[], ...elements.map(() => [])], place)
    this.plot.over.addEventListener('wheel', (event) => this.turned(event, hands), { passive: false })
    this.plot.over.addEventListener('dblclick', () => hands.reset())
    if (hands.go) this.listen(hands.go)
  }

  get canvas(): HTMLCanvasElement {
    return this.plot.ctx.canvas
  }

  /** Fills its place, whatever size that gets, until what is given back is called: then it is gone. */
  fill(place: HTMLElement): () => void {
    const room = new ResizeObserver(() => this.resize(place.clientWidth, place.clientHeight))
    room.observe(place)
    return () => {
      room.disconnect()
      this.plot.destroy()
    }
  }

  show(stretch: Stretch, span: readonly [number, number], marks: readonly Mark[], at_s = NaN): void {
    const { shown } = this
    this.marks = marks
    this.at_s = at_s
    // A recorded stretch stays what it is; only the line at the instant moves.
    if (!Number.isNaN(at_s) && shown?.stretch === stretch && shown.from_s === span[0] && shown.to_s === span[1])
      return this.plot.redraw(false, false)
    this.shown = { stretch, from_s: span[0], to_s: span[1] }
    this.plot.batch(() => {
      this.plot.setData([stretch.t, ...this.elements.map((e) => this.column(stretch.y[e]))] as uPlot.AlignedData, false)
      this.plot.setScale('x', { min: span[0], max: span[1] })
    })
  }

  /** The limits begin anew about what is shown. */
  refit(): void {
    this.former = undefined
  }

  private resize(width: number, height: number): void {
    this.plot.setSize({ width: Math.max(120, width), height: Math.max(60, height) })
  }

  /** Where two runs lie on one line of time, the shorter one ends before the other. */
  private column(row: Float64Array | undefined): ArrayLike<number | null> | undefined {
    return row && Number.isFinite(this.width) ? Array.from(row, (value) => (Number.isNaN(value) ? null : value)) : row
  }

  /** A click is no drag. */
  private listen(go: (at_s: number) => void): void {
    let began = 0
    this.plot.over.addEventListener('pointerdown', (event) => (began = event.clientX))
    this.plot.over.addEventListener(
      'click',
      (event) => Math.abs(event.clientX - began) < 4 && go(this.plot.posToVal(event.offsetX, 'x')),
    )
  }

  private options(place: HTMLElement, hands: Hands): uPlot.Options {
    const { tones } = this
    const axis = {
      stroke: tones['--ink-3'],
      font: `${SMALL} ${this.mono}`,
      ticks: { show: false },
      border: { show: false },
    }
    const minus = (text: string): string => text.replaceAll('-', '−')
    return {
      width: place.clientWidth || 300,
      height: place.clientHeight || 150,
      legend: { show: false },
      padding: [8, NAMES_WIDTH, 0, 0],
      cursor: { y: false, points: { size: 6 }, drag: { x: true, y: false, setScale: false } },
      scales: { x: { time: false }, y: { range: (_, low, high) => this.limits(low, high) } },
      axes: [
        {
          ...axis,
          size: 20,
          gap: 4,
          space: (plot) => Math.max(44, plot.width / 14),
          grid: { show: false },
          values: (_, all) => all.map((at) => minus(`${round(at)} s`)),
        },
        {
          ...axis,
          size: 40,
          gap: 5,
          space: (plot) => Math.max(26, plot.height / 10),
          grid: { stroke: tones['--line'], width: 1 },
          values: (_, all) => all.map((v) => minus(String(round(v)))),
        },
      ],
      series: [{}, ...this.elements.map((e) => this.line(e))],
      hooks: {
        draw: [() => this.drawMarks(), () => this.drawInstant(), () => this.drawNames()],
        setCursor: [(plot) => plot.redraw(false, false)],
        setSelect: [(plot) => this.selected(plot, hands)],
      },
    }
  }

  private line(e: number): uPlot.Series {
    const element = e % this.width
    return {
      stroke: this.tones[hue(element)],
      width: e < this.width ? 1.75 : 3.5,
      alpha: e < this.width ? 1 : 0.35,
      dash: dash(element),
      points: { show: false },
    }
  }

  /** Before the first value there is nothing to hold on to. */
  private limits(low: number, high: number): [number, number] {
    const next = limits(low, high, this.former)
    if (Number.isFinite(low) && Number.isFinite(high)) this.former = next
    return next
  }

  private selected(plot: uPlot, hands: Hands): void {
    const { left, width } = plot.select
    if (width < 4) return
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false)
    this.refit()
    hands.pick(plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x'))
  }

  private turned(event: WheelEvent, hands: Hands): void {
    event.preventDefault()
    const notches = Math.max(-3, Math.min(3, event.deltaY / (event.deltaMode ? 3 : 100)))
    hands.wheel(this.plot.posToVal(event.offsetX, 'x'), notches)
  }

  /** Lines where the state of a task changed; errors with their words. */
  private drawMarks(): void {
    const { ctx, bbox, scales } = this.plot
    const ratio = devicePixelRatio
    ctx.save()
    let free = -Infinity
    for (const mark of this.marks) {
      if (mark.at_s < (scales.x.min ?? 0) || mark.at_s > (scales.x.max ?? 0)) continue
      const x = Math.round(this.plot.valToPos(mark.at_s, 'x', true))
      ctx.strokeStyle = this.tones[mark.isError ? '--error' : '--waiting']
      ctx.lineWidth = (mark.isError ? 1.5 : 1) * ratio
      ctx.setLineDash([2 * ratio, 3 * ratio])
      ctx.beginPath()
      ctx.moveTo(x, bbox.top)
      ctx.lineTo(x, bbox.top + bbox.height)
      ctx.stroke()
      ctx.font = `600 ${10 * ratio}px ${this.sans}`
      const width = ctx.measureText(mark.text).width
      const isLeft = x - width - 5 * ratio > bbox.left
      const start = isLeft ? x - width - 5 * ratio : x + 5 * ratio
      if (start < free) continue // would cover the words before it
      free = start + width
      ctx.fillStyle = this.tones[mark.isError ? '--error-ink' : '--ink-3']
      ctx.textAlign = 'left'
      ctx.fillText(mark.text, start, bbox.top + 9 * ratio)
    }
    ctx.restore()
  }

  /** The instant that is looked at. */
  private drawInstant(): void {
    const { ctx, bbox, scales } = this.plot
    if (!(this.at_s >= (scales.x.min ?? 0) && this.at_s <= (scales.x.max ?? 0))) return
    const x = Math.round(this.plot.valToPos(this.at_s, 'x', true))
    ctx.save()
    ctx.strokeStyle = this.tones['--accent']
    ctx.setLineDash([])
    ctx.lineWidth = 2 * devicePixelRatio
    ctx.beginPath()
    ctx.moveTo(x, bbox.top)
    ctx.lineTo(x, bbox.top + bbox.height)
    ctx.stroke()
    ctx.restore()
  }

  /** Beside the end of each line its name; under the pointer, or at the instant looked at, its value there. */
  private drawNames(): void {
    const { ctx, bbox, data, cursor } = this.plot
    const ratio = devicePixelRatio
    const at = cursor.idx ?? this.index()
    const shown = this.elements.map((element, k) => ({
      element,
      k,
      v: (data[k + 1] as ArrayLike<number>)[at ?? this.last()],
    }))
    const lines = shown.filter((line) => line.element < this.width && Number.isFinite(line.v))
    const wished = lines.map((line) => this.plot.valToPos(line.v, 'y', true))
    const gap = Math.min(NAME_GAP * ratio, bbox.height / Math.max(1, lines.length))
    const places = spread(wished, gap, bbox.top + 4 * ratio, bbox.top + bbox.height - 2 * ratio)
    ctx.save()
    ctx.font = `600 ${10 * ratio}px ${this.mono}`
    ctx.textAlign = 'left'
    ctx.textBaseline = 'middle'
    lines.forEach(({ element, k, v }, i) => {
      ctx.fillStyle = this.tones[hue(element)]
      ctx.fillText(at === undefined ? this.names[k] : number(v), bbox.left + bbox.width + 5 * ratio, places[i])
    })
    ctx.restore()
  }

  /** The sample at the instant that is looked at. */
  private index(): number | undefined {
    return Number.isNaN(this.at_s) || !this.plot.data[0].length ? undefined : this.plot.valToIdx(this.at_s)
  }

  /** The newest sample that is in view. */
  private last(): number {
    const t = this.plot.data[0] as ArrayLike<number>
    const end = this.plot.scales.x.max ?? Infinity
    let k = t.length - 1
    while (k > 0 && t[k] > end) k -= 1
    return k
  }
}

const round = (value: number): number => Math.round(value * 1e6) / 1e6
