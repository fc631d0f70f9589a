// What a canvas draws of one document: boxes, dots and the lines between them. Places come from the document, except
// those of what is held under the pointer; ways of lines are worked out here and told to nobody.
import { untrack } from 'svelte'
import { SvelteMap } from 'svelte/reactivity'
import type { DocumentView, LocusView, PinView, TaskView } from '../api.gen'
import { placeLabels } from '../geom/labels'
import { pathOf } from '../geom/path'
import { areaOf, overlaps, type Area, type Pt, type Rect } from '../geom/rect'
import { Wires, type Pin } from '../geom/wires'
import { isLeft, preference } from './pin'
import { trunk } from './trunk'

/** A box whose task no open library knows. */
const MISSING = { width: 136, height: 86 }
const NAME_FITS = 15
/** Lines side by side that are farther apart would leave their corridors. */
const FARTHEST = 20
/** The size of a name beside its dot. */
const LETTER = 6.4
const LINE = 13
const NO_PINS: readonly PinView[] = []

export class Box {
  readonly name: string
  x = $state(0)
  y = $state(0)
  inLeft = $state(true)
  width = $state(MISSING.width)
  height = $state(MISSING.height)
  pins: readonly PinView[] = $state.raw(NO_PINS)
  /** Held under the pointer: the document does not move it meanwhile. */
  isHeld = false

  constructor(name: string) {
    this.name = name
  }

  get rect(): Rect {
    return { x: this.x, y: this.y, w: this.width, h: this.height }
  }

  /** Its name in one line, or in two where it is longer than a line is to be. */
  shownName(longest = NAME_FITS): string[] {
    return nameLines(this.name, Math.min(longest, NAME_FITS))
  }
}

/** A name in lines of so many signs: parted behind a sign that parts words, if it has one there; two lines at most. */
export function nameLines(name: string, longest: number): string[] {
  if (name.length <= longest) return [name]
  const parting = name.slice(0, longest).search(/[_.-][^_.-]*$/) + 1
  const at = parting || longest
  const rest = name.slice(at)
  return [name.slice(0, at), rest.length > NAME_FITS ? `${rest.slice(0, NAME_FITS - 1)}…` : rest]
}

/** Where a name stands beside its dot. */
export interface Label {
  dx: number
  dy: number
  anchor: 'start' | 'middle' | 'end'
}

export class Dot {
  readonly svar: string
  x = $state(0)
  y = $state(0)
  label: Label = $state.raw({ dx: 0, dy: -10, anchor: 'middle' })
  isHeld = false
  /** Whether its lines are drawn. */
  isShown = true

  constructor(svar: string) {
    this.svar = svar
  }

  get rect(): Rect {
    return { x: this.x - 5, y: this.y - 5, w: 10, h: 10 }
  }
}

/** The lines of one variable, as one drawing. */
export class Net {
  readonly svar: string
  d = $state.raw('')
  readonly routes = new Map<string, readonly Pt[]>()

  constructor(svar: string) {
    this.svar = svar
  }
}

/** Which lines are drawn at all: by kind of pin (§A.5), and constants only on demand. */
export interface Shown {
  kinds: ReadonlySet<string>
  constants: boolean
  /** Constants whose lines are shown although the others are not. */
  opened: ReadonlySet<string>
  /** How far lines that run side by side are apart, in pixels. */
  apart?: number
}

/** The preferences that `Shown.kinds` may hold. */
export const KINDS = ['show_inconst', 'show_outconst', 'show_invar', 'show_outvar'] as const

export class Scene {
  readonly doc: string
  readonly boxes = new SvelteMap<string, Box>()
  readonly dots = new SvelteMap<string, Dot>()
  readonly nets = new SvelteMap<string, Net>()
  readonly wires = new Wires()
  /** Grows when the document was followed: who depends on this is not bothered by what only moves under the pointer. */
  layout = $state(0)
  private readonly reading = new Map<string, Told>()
  /** Which variable a link is of, and which drawing holds its line; these differ while a pin gets another name. */
  private readonly svarOf = new Map<string, string>()
  private readonly drawnIn = new Map<string, Net>()

  constructor(doc: string) {
    this.doc = doc
  }

  /** Take over what the document says now. It is read first, so that an effect depends on that and on nothing else. */
  follow(document: DocumentView, tasks: Readonly<Record<string, TaskView>>, shown: Shown): void {
    const reading = read(document, tasks)
    const { kinds, constants, opened, apart } = shown
    const plain = { kinds, constants, opened: new Set(opened) }
    untrack(() => {
      if (apart) this.wires.keepApart(Math.min(apart, FARTHEST))
      this.followLoci(reading.loci, plain)
      this.followTasks(reading, plain)
      this.redraw()
      this.layout += 1
    })
  }

  /** Put a box or a dot under the pointer. */
  hold(name: string, x: number, y: number): void {
    const box = this.boxes.get(name)
    if (!box || (box.x === x && box.y === y)) return
    box.x = x
    box.y = y
    const reading = this.reading.get(name)
    if (reading) reading.rect = box.rect
    this.wires.setBox(name, box.rect, reading?.pins ?? [])
  }

  holdDot(svar: string, x: number, y: number): void {
    const dot = this.dots.get(svar)
    if (!dot) return
    dot.x = x
    dot.y = y
    this.wires.setLocus(svar, x, y, dot.isShown)
  }

  /** Bring the drawn lines up to date. */
  redraw(): void {
    const routes = this.wires.routes()
    const touched = new Set<Net>()
    for (const link of this.wires.takeChanged()) {
      const route = routes.get(link)
      const net = this.nets.get(this.svarOf.get(link) ?? '')
      const before = this.drawnIn.get(link)
      if (before?.routes.delete(link)) touched.add(before)
      this.drawnIn.delete(link)
      if (!net || !route) continue
      net.routes.set(link, route)
      this.drawnIn.set(link, net)
      touched.add(net)
    }
    for (const net of touched)
      net.d = trunk(net.routes.values())
        .map((route) => pathOf(route))
        .join('')
  }

  /** Find places for the names of the variables where they cover nothing. */
  nameDots(): void {
    const labels = [...this.dots.values()].map(({ svar, x, y }) => ({
      svar,
      x,
      y,
      w: svar.length * LETTER + 4,
      h: LINE,
    }))
    const boxes = [...this.boxes.values()].map(({ rect }) => areaOf(rect))
    for (const { svar, x0, y0, x1, y1 } of placeLabels(labels, boxes, this.wires.routes().values())) {
      const dot = this.dots.get(svar)
      if (!dot) continue
      const side = x0 >= dot.x ? 'start' : x1 <= dot.x ? 'end' : 'middle'
      const dx = side === 'start' ? x0 - dot.x + 2 : side === 'end' ? x1 - dot.x - 2 : 0
      const label: Label = { dx, dy: (y0 + y1) / 2 - dot.y + 3.5, anchor: side }
      if (label.dx !== dot.label.dx || label.dy !== dot.label.dy || label.anchor !== dot.label.anchor) dot.label = label
    }
  }

  /** The smallest rectangle around these boxes, or around everything. */
  bounds(names: Iterable<string> = this.boxes.keys()): Rect | undefined {
    const rects = [...names].map((name) => this.boxes.get(name)?.rect).filter((rect) => rect !== undefined)
    if (!rects.length) return undefined
    const x = Math.min(...rects.map((r) => r.x))
    const y = Math.min(...rects.map((r) => r.y))
    return { x, y, w: Math.max(...rects.map((r) => r.x + r.w)) - x, h: Math.max(...rects.map((r) => r.y + r.h)) - y }
  }

  dotsIn(area: Area): Dot[] {
    return [...this.dots.values()].filter(({ rect }) => overlaps(areaOf(rect), area))
  }

  boxesIn(area: Area): Box[] {
    return [...this.boxes.values()].filter(({ rect }) => overlaps(areaOf(rect), area))
  }

  private followTasks({ tasks, loci }: Read, shown: Shown): void {
    for (const name of [...this.boxes.keys()])
      if (!tasks.has(name)) {
        this.boxes.delete(name)
        this.reading.delete(name)
        this.wires.removeBox(name)
      }
    for (const [name, boxOfTask] of tasks) {
      const box = this.boxes.get(name) ?? new Box(name)
      if (!box.isHeld) Object.assign(box, { x: boxOfTask.x, y: boxOfTask.y })
      Object.assign(box, {
        inLeft: boxOfTask.inLeft,
        width: boxOfTask.width,
        height: boxOfTask.height,
        pins: boxOfTask.pins,
      })
      this.boxes.set(name, box)
      this.tell(box, (pin) => isDrawn(pin, loci.get(pin.svar), shown))
    }
  }

  private followLoci(loci: Read['loci'], shown: Shown): void {
    for (const svar of [...this.dots.keys()]) {
      const locus = loci.get(svar)
      if (locus && isOnCanvas(svar, locus, shown)) continue
      this.dots.delete(svar)
      this.nets.delete(svar)
      this.wires.removeLocus(svar)
    }
    for (const [svar, locus] of loci) {
      if (!isOnCanvas(svar, locus, shown)) continue
      const dot = this.dots.get(svar) ?? new Dot(svar)
      if (!dot.isHeld) Object.assign(dot, { x: locus.x, y: locus.y })
      dot.isShown = locus.is_shown
      this.dots.set(svar, dot)
      if (!this.nets.has(svar)) this.nets.set(svar, new Net(svar))
      this.wires.setLocus(svar, dot.x, dot.y, dot.isShown)
    }
  }

  /** Tell the wires of a box where anything about it is new. */
  private tell(box: Box, isDrawn: (pin: PinView) => boolean): void {
    const drawn = box.pins.filter(isDrawn)
    const reading = this.reading.get(box.name)
    const now: Told = {
      rect: box.rect,
      inLeft: box.inLeft,
      key: drawn.map((pin) => `${pin.name}=${pin.svar}`).join(),
      all: box.pins,
      pins: [],
    }
    if (reading && isSame(reading, now)) return
    now.pins = drawn.map((pin) => ({
      id: pin.name,
      svar: pin.svar,
      side: isLeft(pin, box.inLeft) ? 'left' : 'right',
      dy: pin.y,
    }))
    for (const pin of drawn) this.svarOf.set(`${box.name}/${pin.name}`, pin.svar)
    this.reading.set(box.name, now)
    this.wires.setBox(box.name, now.rect, now.pins)
  }
}

interface Told {
  rect: Rect
  inLeft: boolean
  key: string
  all: readonly PinView[]
  pins: Pin[]
}

const isSame = (a: Told, b: Told): boolean =>
  a.all === b.all &&
  a.key === b.key &&
  a.inLeft === b.inLeft &&
  a.rect.x === b.rect.x &&
  a.rect.y === b.rect.y &&
  a.rect.w === b.rect.w &&
  a.rect.h === b.rect.h

interface Locus {
  x: number
  y: number
  is_shown: boolean
  is_constant: boolean
}

/** What a document says of places, copied out of the tree. */
interface Read {
  tasks: Map<string, { x: number; y: number; inLeft: boolean; width: number; height: number; pins: readonly PinView[] }>
  loci: Map<string, Locus>
}

function read(document: DocumentView, tasks: Readonly<Record<string, TaskView>>): Read {
  const placed = Object.entries(document.tasks ?? {}).map(([name, position]) => {
    const task = document.own?.[name] ?? tasks[name]
    const width = task?.width || MISSING.width
    const height = task?.height || MISSING.height
    return [
      name,
      {
        x: position.x,
        y: position.y,
        inLeft: position.in_left ?? true,
        width,
        height,
        pins: task ? plain(task.pins) : NO_PINS,
      },
    ] as const
  })
  const loci = Object.entries(document.loci ?? {}).map(
    ([svar, { x, y, is_shown = true, is_constant = false }]) => [svar, { x, y, is_shown, is_constant }] as const,
  )
  return { tasks: new Map(placed), loci: new Map(loci) }
}

/** Pins are replaced as a whole or not at all: a copy serves as long as they are the same. */
const COPIES = new WeakMap<readonly PinView[], readonly PinView[]>()
function plain(pins: readonly PinView[]): readonly PinView[] {
  let copy = COPIES.get(pins)
  if (!copy) COPIES.set(pins, (copy = untrack(() => pins.map((pin) => ({ ...pin })))))
  return copy
}

/** Whether a dot stands at its place; constants otherwise stand in a row at the edge of the canvas. */
export const isOnCanvas = (svar: string, locus: Pick<LocusView, 'is_constant' | 'is_shown'>, shown: Shown): boolean =>
  !locus.is_constant || (locus.is_shown !== false && (shown.constants || shown.opened.has(svar)))

const isDrawn = (pin: PinView, locus: Locus | undefined, shown: Shown): boolean =>
  locus !== undefined && isOnCanvas(pin.svar, locus, shown) && preference(pin).some((kind) => shown.kinds.has(kind))
