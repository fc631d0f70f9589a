// The one pad of this browser: whatever is held in the hand, sent to the runtime as long as the pad is open (K07).
import { desk } from '../link/desk.svelte'
import { send } from '../link/link'
import { note } from '../link/note'
import { Refusal } from '../link/refusal'
import { fromDown, fromDrag, fromGamepad, KEYS } from './devices'
import { FREE, together, type Frame, type Pushed } from './push'
import { PushTimes } from './sending'

const LOOK_MS = 16
/** How long the button is held at most that tells the job to go on; it is let go as soon as nobody listens any more. */
const PRESS_MS = 3000

type Place = readonly [axis: number, sign: 1 | -1]

class Pad {
  isOpen = $state(false)
  frame: Frame = $state('world')
  scale = $state(0.5)
  /** Whether somebody is led now. */
  isLeading = $state(false)
  /** Whether a job listens; undefined: nothing has been heard yet. */
  listens: boolean | undefined = $state()
  /** Why nobody is led. */
  why = $state('')
  /** What gamepads there are, by their names. */
  gamepads: readonly string[] = $state.raw([])
  /** What is done where the button of a gamepad is pressed that keeps the pose. */
  onKeep: (() => void) | undefined

  private timer: ReturnType<typeof setInterval> | undefined
  private times = new PushTimes()
  private readonly keys = new Map<string, Place>()
  private readonly places = new Map<number, Place>()
  private across: readonly [number, number, number] | undefined
  private pressedUntil = 0
  private wasKept = false

  open(): void {
    if (this.isOpen) return
    this.isOpen = true
    this.times = new PushTimes()
    this.listens = undefined
    this.timer = setInterval(() => this.look(), LOOK_MS)
    addEventListener('blur', this.letGo)
    document.addEventListener('visibilitychange', this.hide)
  }

  close(): void {
    if (!this.isOpen) return
    this.letGo()
    this.say(FREE)
    this.isOpen = this.isLeading = false
    clearInterval(this.timer)
    removeEventListener('blur', this.letGo)
    document.removeEventListener('visibilitychange', this.hide)
  }

  /** A key goes down or up; whether it means anything here. */
  key(code: string, isDown: boolean): boolean {
    const place = KEYS[code]
    if (!place) return false
    if (isDown) this.keys.set(code, place)
    else this.keys.delete(code)
    this.look()
    return true
  }

  /** A finger, by its number, lies on a place of the pad on the screen, or on none. */
  touch(finger: number, place?: Place): void {
    if (place) this.places.set(finger, place)
    else this.places.delete(finger)
    this.look()
  }

  /** The tool is dragged so far, in m of the world; undefined: it is let go. */
  drag(across?: readonly [number, number, number]): void {
    this.across = across
    this.look()
  }

  /** Tell the job to go on. */
  goOn(): void {
    this.pressedUntil = performance.now() + PRESS_MS
    this.look()
  }

  /** Whoever looks elsewhere leads nothing: what is held then is not seen to be let go. */
  private readonly letGo = (): void => {
    this.keys.clear()
    this.places.clear()
    this.across = undefined
    if (this.isOpen) this.look()
  }
  private readonly hide = (): void => {
    if (document.hidden) this.letGo()
  }

  private get isSeen(): boolean {
    return !document.hidden && document.hasFocus()
  }

  private look(): void {
    const pads = [...navigator.getGamepads()].filter((pad) => pad?.connected)
    const names = pads.map((pad) => pad!.id)
    if (names.join() !== this.gamepads.join()) this.gamepads = names
    const held = this.isSeen ? pads.map(fromGamepad) : []
    this.keep(held.some(({ isPressed }) => isPressed))
    const pushed = together([
      ...held,
      fromDown([...this.keys.values(), ...this.places.values()]),
      fromDrag(this.across),
    ])
    const now = performance.now()
    const said = { ...pushed, isPressed: now < this.pressedUntil }
    if (this.times.isDue(now, said.isHeld, said.isPressed)) this.say(said, now)
  }

  /** A press of the gamepad keeps the pose once. */
  private keep(isPressed: boolean): void {
    if (isPressed && !this.wasKept) this.onKeep?.()
    this.wasKept = isPressed
  }

  private say({ axes, isHeld, isPressed }: Pushed, now = performance.now()): void {
    if (isHeld !== this.isLeading) note(isHeld ? 'take_pad' : 'leave_pad', '', '', 'appl')
    this.isLeading = isHeld
    const times = this.times
    times.sent(now, isHeld, isPressed)
    const frame = this.across ? 'world' : this.frame
    void send({
      t: 'Push',
      axes: [...axes],
      is_held: isHeld,
      button: isPressed,
      scale: this.scale,
      frame,
      source: desk.you,
    })
      .then(
        () => this.told(''),
        (why: unknown) => this.told(why instanceof Refusal ? why.reason : String(why)),
      )
      .finally(() => times.answered())
  }

  private told(why: string): void {
    this.listens = why === ''
    this.why = why
    if (why) this.pressedUntil = 0
  }
}

export const pad = new Pad()
