// The rooms of src and who may import whom: a room uses those below its own only, so that no two depend on each other.
import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, normalize, sep } from 'node:path'
import { expect, test } from 'vitest'

/** From the top to the ground; rooms on one floor do not know each other. Files of no room stand in `TOP` and `GROUND`. */
const FLOORS: readonly (readonly string[])[] = [
  ['player', 'board'],
  ['commands'],
  ['shell'],
  ['review', 'dictionary', 'stop'],
  ['workspace', 'canvas', 'monitor'],
  ['run', 'task'],
  ['help', 'foresight', 'library', 'group', 'holding', 'redirect', 'world3d'],
  ['files', 'picture', 'recording', 'question', 'scene', 'pad'],
  ['application', 'progress'],
  ['onikon', 'sentences'],
  ['gesture', 'widgets', 'values'],
  ['act'],
  ['link'],
  ['texts'],
  ['state', 'geom'],
]
const TOP = ['App.svelte', 'Dialog.svelte', 'main.ts']
const GROUND = ['api.gen.ts', 'theme.css']
const LARGEST = 35

const SOURCES = new URL('../src/', import.meta.url).pathname
const floorOf = new Map(FLOORS.flatMap((rooms, floor) => rooms.map((room) => [room, floor] as const)))
const files = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' }).filter((path) => /\.\w+$/.test(path))
const roomOf = (path: string): string => (path.includes(sep) ? path.slice(0, path.indexOf(sep)) : '')

/** What a file imports, as paths below src without endings; also types, and what is fetched later. */
function importsOf(path: string): string[] {
  const text = readFileSync(join(SOURCES, path), 'utf8')
  const specifiers = [...text.matchAll(/(?:\bfrom|\bimport|\bimport\()\s*'(\.{1,2}\/[^']+)'/g)].map(
    (match) => match[1]!,
  )
  return specifiers.map((specifier) => normalize(join(dirname(path), specifier)))
}

function isAllowed(path: string, target: string): boolean {
  const [from, to] = [roomOf(path), roomOf(target)]
  if (from === to || TOP.includes(path)) return true
  if (!to) return GROUND.some((file) => file.startsWith(target))
  return floorOf.get(from)! < floorOf.get(to)!
}

test('each folder is a room with a floor, and each room is there', () => {
  const folders = new Set(files.map(roomOf).filter(Boolean))
  expect([...folders].sort()).toEqual([...floorOf.keys()].sort())
})

test('a folder holds folders or files of the page, and beside the folders stand few files', () => {
  expect(files.filter((path) => path.split(sep).length > 2)).toEqual([])
  expect(files.filter((path) => !roomOf(path)).sort()).toEqual([...TOP, ...GROUND].sort())
})

test.each([...floorOf.keys()])('%s imports rooms below it only', (room) => {
  const upwards = files
    .filter((path) => roomOf(path) === room)
    .flatMap((path) =>
      importsOf(path)
        .filter((target) => !isAllowed(path, target))
        .map((target) => `${path} imports ${target}`),
    )
  expect(upwards).toEqual([])
})

test('no room is larger than what one overlooks', () => {
  const sizes = [...floorOf.keys()].map((room) => [room, files.filter((path) => roomOf(path) === room).length] as const)
  expect(sizes.filter(([, size]) => size > LARGEST)).toEqual([])
})
