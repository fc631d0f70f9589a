// The class as the board knows it: asked for once a second; what the teacher does is asked of its front.
import type { ClassBoard, SeatRow, TeacherAct } from '../api.gen'
import { look } from '../state/look.svelte'

const LOOK_MS = 1000

class Room {
  board: ClassBoard | undefined = $state()
  /** Whether the class answers. */
  isLost = $state(false)
  /** Whether this browser is not let in any more. */
  isLocked = $state(false)
  /** What was refused last, in words. */
  wrong = $state('')
  /** The seats that are chosen; none: all of them are meant. */
  chosen: ReadonlySet<number> = $state(new Set<number>())
}

export const room = new Room()

/** The seats that a command is about. */
export const meant = (): number[] =>
  (room.board?.rows ?? []).map((row) => row.seat).filter((seat) => !room.chosen.size || room.chosen.has(seat))

export function choose(seat: number, isChosen: boolean): void {
  const chosen = new Set(room.chosen)
  if (isChosen) chosen.add(seat)
  else chosen.delete(seat)
  room.chosen = chosen
}

export async function lookOnce(): Promise<void> {
  try {
    const answer = await fetch('board/state')
    room.isLocked = answer.status === 403
    room.isLost = !answer.ok && !room.isLocked
    if (answer.ok) room.board = (await answer.json()) as ClassBoard
  } catch {
    room.isLost = true
  }
}

/** Look again and again, until the answer is called. */
export function keepLooking(): () => void {
  let isOver = false
  const again = async (): Promise<void> => {
    while (!isOver) {
      await lookOnce()
      await new Promise((done) => setTimeout(done, LOOK_MS))
    }
  }
  void again()
  return () => (isOver = true)
}

export async function ask(act: TeacherAct['act'], seats: number[], text = ''): Promise<boolean> {
  room.wrong = ''
  try {
    const answer = await fetch(`board/act?lang=${look.language}`, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ act, seats, text }),
    })
    if (!answer.ok) room.wrong = (await answer.text()).trim()
    await lookOnce()
    return answer.ok
  } catch {
    room.isLost = true
    return false
  }
}

/** How many expectations of the last hand-in hold, of how many. */
export const score = (row: SeatRow): [number, number] => [
  row.expectations.filter((one) => one.holds).length,
  row.expectations.length,
]
