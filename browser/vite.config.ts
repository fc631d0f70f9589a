// How the page is built: into the Python package, with relative addresses, so that it may be served below any path.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import type { Plugin } from 'vite'
import { defineConfig } from 'vitest/config'

// While developing, the page comes from here and everything live from a program that runs beside it.
const program = process.env.ONIKA_ADDRESS ?? 'http://127.0.0.1:8420'

/** Beside each file of the page one that is packed, for those who open the page from afar. */
const packed: Plugin = {
  name: 'packed',
  apply: 'build',
  writeBundle({ dir = '' }) {
    const assets = join(dir, 'assets')
    for (const name of readdirSync(assets)) {
      writeFileSync(join(assets, `${name}.gz`), gzipSync(readFileSync(join(assets, name)), { level: 9 }))
    }
  },
}

export default defineConfig({
  plugins: [svelte(), packed],
  base: './',
  build: {
    outDir: '../src/onika/web/static',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1024, // three.js, fetched only when a workcell is looked at
  },
  // the program lets in its own page only; the cookie comes from opening its printed address first
  server: {
    host: '127.0.0.1',
    proxy: { '/ws': { target: program, ws: true, changeOrigin: true, rewriteWsOrigin: true } },
  },
  test: {
    include: ['test/**/*.test.ts'],
    environment: 'node',
    pool: 'threads',
    passWithNoTests: true,
    testTimeout: 60_000, // a busy machine is no fault
  },
})
