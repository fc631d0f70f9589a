// The recorded run that is looked at, and the instant of it that this browser shows. All that is drawn follows it.
import { untrack } from 'svelte'
import type { AnyAct, InstantView, RecordingView, ReviewView, StretchView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { showFrom, stir, type Source } from '../values/frames'
import { look } from '../state/look.svelte'
import { workspace } from '../state/workspace.svelte'
import { keep, kept } from '../state/kept'
import { send } from '../link/link'
import { subsystemOf } from '../progress/inside'
import { Past } from '../progress/past'
import { Refusal } from '../link/refusal'
import type { Marked } from '../values/marks'
import { LatestRequest } from './latestRequest'
import { Courses, RecordedPast, type Course } from './courses'
import { beginnings, blocksUntil, endOf, nextTo, stepsOf } from './lanes'
import { treeAt } from './treeAt'
import { say } from '../texts/say'

export const PACES = [0.5, 1, 2, 4] as const
const KEEP_MS = 300

class Review implements Source {
  /** Where it is scrubbed to. */
  at_s = $state(0)
  /** What it was like there, and in the run beside it. */
  instant: InstantView | undefined = $state.raw()
  beside: InstantView | undefined = $state.raw()
  isPlaying = $state(false)
  /** Whether a file is being made of it. */
  isSharing = $state(false)
  pace = $state(kept('reviewPace', 1))
  /** Why an instant could not be shown. */
  trouble = $state('')
  readonly figures = {}
  /** What went wrong, as lines in plots. */
  readonly plotted: Marked = {
    of: () =>
      (this.recording?.marks ?? [])
        .filter((mark) => mark.kind === 'error' || mark.kind === 'stop')
        .map((mark) => ({ at_s: mark.at_s, task: '', text: say(mark.text), isError: true })),
  }
  private courses: [Courses?, Courses?] = []
  private keeping: ReturnType<typeof setTimeout> | undefined
  private readonly request = new LatestRequest<[InstantView, InstantView | undefined]>(
    (at_s) => this.ask(at_s),
    ([instant, beside]) => this.take(instant, beside),
    (why) => (this.trouble = why instanceof Refusal ? why.reason : String(why)),
    (run) => requestAnimationFrame(run),
  )

  get view(): ReviewView | null {
    return desk.live.review
  }

  get isOpen(): boolean {
    return this.view !== null
  }

  get recording(): RecordingView | undefined {
    return this.view?.recording
  }

  get other(): RecordingView | undefined {
    return this.view?.other ?? undefined
  }

  readonly begin_s = $derived(this.recording?.begin_s ?? 0)
  /** Of the longer one, where two lie beside each other. */
  readonly end_s = $derived(
    Math.max(this.recording ? endOf(this.recording) : 0, this.other ? endOf(this.other) : 0, this.begin_s),
  )
  private readonly moments = $derived(this.recording ? beginnings(this.recording) : [])
  private readonly marks = $derived(
    (this.recording?.marks ?? []).map((mark) => mark.at_s).sort((moment, other) => moment - other),
  )

  /** The actions up to the instant that is shown. */
  get past(): Past {
    const { recording, instant } = this
    if (!recording || !instant) return new Past()
    const stopped = Object.values(instant.run.flows ?? {})
      .filter((flow) => flow.state === 'stopped')
      .map((flow) => flow.order)
    return new Past(instant.run.number, blocksUntil(recording, instant.at_s, new Set(stopped)))
  }

  get shown_s(): number {
    return this.instant?.at_s ?? this.at_s
  }

  get now_s(): number {
    return this.shown_s
  }

  /** Go to an instant. */
  go(at_s: number): void {
    if (!this.isOpen || !Number.isFinite(at_s)) return
    this.at_s = Math.min(this.end_s, Math.max(this.begin_s, at_s))
    this.request.want(this.at_s)
    clearTimeout(this.keeping)
    this.keeping = setTimeout(
      () => this.isOpen && keep('review', { path: this.recording?.path ?? '', at_s: this.at_s }),
      KEEP_MS,
    )
  }

  /** To where an action begins, before or after here. */
  step(way: 1 | -1): void {
    this.isPlaying = false
    this.go(nextTo(this.moments, this.at_s, way) ?? (way > 0 ? this.end_s : this.begin_s))
  }

  /** To the next thing that is marked; the time of it, or undefined where there is none. */
  toMark(way: 1 | -1): number | undefined {
    const at_s = nextTo(this.marks, this.at_s, way)
    this.isPlaying = false
    if (at_s !== undefined) this.go(at_s)
    return at_s
  }

  play(): void {
    if (this.isPlaying || !this.isOpen) {
      this.isPlaying = false
      return
    }
    if (this.at_s >= this.end_s) this.go(this.begin_s)
    this.isPlaying = true
    let last_ms = performance.now()
    const on = (now_ms: number): void => {
      if (!this.isPlaying || !this.isOpen) return
      this.go(this.at_s + (Math.max(0, now_ms - last_ms) / 1000) * this.pace)
      last_ms = now_ms
      if (this.at_s >= this.end_s) this.isPlaying = false
      else requestAnimationFrame(on)
    }
    requestAnimationFrame(on)
  }

  setPace(pace: number): void {
    this.pace = pace
    keep('reviewPace', pace)
  }

  latest(key: string): unknown {
    return this.instant?.values?.[this.nameOf(key)]
  }

  series(key: string): RecordedPast | undefined {
    const course = this.recording?.variables?.[this.nameOf(key)] ? this.courses[0]?.of(this.nameOf(key)) : undefined
    return course && new RecordedPast(course, this.shown_s)
  }

  /** A stretch of a variable in this run and in the one beside it. */
  between(key: string, from_s: number, to_s: number): [Course | undefined, Course | undefined] {
    const name = this.nameOf(key)
    const find = (courses: Courses | undefined, of: RecordingView | undefined): Course | undefined =>
      of?.variables?.[name] ? courses?.between(name, from_s, to_s) : undefined
    return [find(this.courses[0], this.recording), find(this.courses[1], this.other)]
  }

  poses(world: string, isOther = false): unknown {
    return (isOther ? this.beside : this.instant)?.poses?.[world]
  }

  isRecorded(key: string): boolean {
    return this.recording?.variables?.[this.nameOf(key)] !== undefined
  }

  /** Another recording is looked at, or none. */
  turnTo(path: string): void {
    this.isPlaying = false
    this.request.forget()
    this.instant = this.beside = undefined
    this.trouble = ''
    showFrom(path ? this : undefined)
    if (!path) return
    const before = kept('review', { path: '', at_s: 0 })
    this.at_s = this.begin_s
    this.go(before.path === path ? before.at_s : this.begin_s)
    const doc = this.recording?.doc ?? ''
    if (doc in desk.live.applications && before.path !== path) {
      workspace.app = doc
      look.level = 'applications'
    }
  }

  /** All is asked for anew: another run lies beside it, or the line is back. */
  renew(): void {
    for (const course of this.courses) course?.end()
    this.courses = [this.coursesOf(this.recording, false), this.coursesOf(this.other, true)]
    this.beside = undefined
    if (this.isOpen) this.go(this.at_s)
    stir()
  }

  private coursesOf(recording: RecordingView | undefined, of_other: boolean): Courses | undefined {
    if (!recording) return undefined
    const ask = async (variable: string, begin_s: number, end_s: number): Promise<readonly StretchView[]> =>
      (await send({ t: 'Course', variable, begin_s, end_s, of_other })) as StretchView[]
    return new Courses(recording.begin_s ?? 0, endOf(recording), ask, stir)
  }

  private async ask(at_s: number): Promise<[InstantView, InstantView | undefined]> {
    const glance = (of_other: boolean, recording: RecordingView): Promise<unknown> =>
      send({ t: 'Glance', at_s: Math.min(Math.max(at_s, recording.begin_s ?? 0), endOf(recording)), of_other })
    const [instant, other] = await Promise.all([
      this.recording && glance(false, this.recording),
      this.other && glance(true, this.other),
    ])
    return [instant as InstantView, other as InstantView | undefined]
  }

  private take(instant: InstantView, beside: InstantView | undefined): void {
    if (!this.isOpen) return
    this.instant = instant
    this.beside = beside
    this.trouble = ''
    stir()
  }

  /** As it was recorded: `SUBSYSTEM/NAME` of a `DOC/NAME`. */
  private nameOf(key: string): string {
    const slash = key.indexOf('/')
    const doc = key.slice(0, slash)
    return `${subsystemOf(doc) || (this.instant?.homes?.[doc] ?? '')}/${key.slice(slash + 1)}`
  }
}

export const review = new Review()
desk.treeAt = treeAt(() => ({
  instant: review.instant,
  worlds: review.recording?.worlds ?? [],
  doc: review.recording?.doc ?? '',
  redirects: review.recording?.redirects ?? [],
  inside: review.recording?.inside ?? {},
}))
/** Asks what a world consists of: the one that is there, or as it was recorded. */
export const sceneOf = (world: string, of_other = false): AnyAct =>
  review.isOpen ? { t: 'RecordedScene', world, at_s: review.shown_s, of_other } : { t: 'Scene', world }

export const isReviewing = (): boolean => desk.live.review !== null

// It listens as long as the page is there.
$effect.root(() => {
  const path = $derived(desk.live.review?.recording.path ?? '')
  const other = $derived(desk.live.review?.other?.path ?? '')
  const line = $derived(desk.isLinked)
  const docs = $derived(Object.keys(desk.live.documents).join())
  const icons = $derived(stepsOf(desk.live.review?.recording))
  $effect(() => {
    const now = path
    untrack(() => review.turnTo(now))
  })
  $effect(() => {
    const now = path
    void other
    if (!line && now) return
    untrack(() => review.renew())
  })
  // A configuration that has been opened meanwhile was somewhere, too; an application that has been is shown at its icons.
  $effect(() => {
    void docs
    void icons
    untrack(() => review.go(review.at_s))
  })
})
