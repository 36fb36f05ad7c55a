#!/usr/bin/env python3
"""Writes variants of labelled files that lack some of the evidence: vary.py FOLDER OUT"""
import json, os, struct, sys, copy, shutil
import numpy as np
def read_glb(path):
    d=open(path,'rb').read(); n=struct.unpack_from('<I',d,12)[0]
    j=json.loads(d[20:20+n]); b=b''
    if len(d)>20+n: m=struct.unpack_from('<I',d,20+n)[0]; b=d[28+n:28+n+m]
    return j,b
def write_glb(path,j,b):
    t=json.dumps(j).encode(); t+=b' '*(-len(t)%4); b+=b'\0'*(-len(b)%4)
    out=struct.pack('<4sII',b'glTF',2,12+8+len(t)+(8+len(b) if b else 0))+struct.pack('<I4s',len(t),b'JSON')+t
    if b: out+=struct.pack('<I4s',len(b),b'BIN\0')+b
    open(path,'wb').write(out)
def neutral(j):
    for kind,word in (('materials','Material.%03d'),('meshes','Object_%d'),('images','image_%d'),('textures','tex_%d')):
        for i,x in enumerate(j.get(kind,[])): x['name']=word%i
    carriers=[i for i,n in enumerate(j['nodes']) if 'mesh' in n]
    for i in carriers: j['nodes'][i]['name']='Object_%d'%i
def neutral_bones(j):
    for i,n in enumerate(j['nodes']):
        if 'mesh' not in n: n['name']='Bone.%03d'%i
    for e in ('VRM','VRMC_vrm','VRMC_springBone'): j.get('extensions',{}).pop(e,None)
def turn(j,degrees=180):
    a=np.radians(degrees)/2
    roots=j['scenes'][j.get('scene',0)]['nodes']
    j['nodes'].append({'name':'Turned','rotation':[0,float(np.sin(a)),0,float(np.cos(a))],'children':roots})
    j['scenes'][j.get('scene',0)]['nodes']=[len(j['nodes'])-1]
def scale(j,f):
    roots=j['scenes'][j.get('scene',0)]['nodes']
    j['nodes'].append({'name':'Scaled','scale':[f]*3,'children':roots})
    j['scenes'][j.get('scene',0)]['nodes']=[len(j['nodes'])-1]
def keep_meshes(j,keep):
    """keep(mesh name, material name)"""
    for i,n in enumerate(j['nodes']):
        if 'mesh' not in n: continue
        m=copy.deepcopy(j['meshes'][n['mesh']])
        p=[q for q in m['primitives'] if keep(n.get('name',''),m.get('name',''),j['materials'][q['material']].get('name','') if 'material' in q else '')]
        if not p: del n['mesh']; n.pop('skin',None); continue
        m['primitives']=p; j['meshes'].append(m); n['mesh']=len(j['meshes'])-1
def drop_skin(j,b):
    # only where nodes are at the identity otherwise: bind pose positions are in mesh space
    for n in j['nodes']: n.pop('skin',None)
    for m in j['meshes']:
        for p in m['primitives']:
            for k in list(p['attributes']):
                if k.startswith(('JOINTS','WEIGHTS')): del p['attributes'][k]
    j.pop('skins',None)
def rot(v): return [-v[0],v[1],-v[2]]
def rotate_truth(t):
    t=copy.deepcopy(t)
    s=t.get('select',{})
    for k in ('points','not'):
        if k in s: s[k]=[rot(p) for p in s[k]]
    if 'head' in t: t['head']['center']=rot(t['head']['center'])
    def box(b):
        lo,hi=rot(b[0]),rot(b[1]); return [[min(lo[i],hi[i]) for i in range(3)],[max(lo[i],hi[i]) for i in range(3)]]
    for k in ('moves','rigid'):
        for r in t.get(k,[]): r['box']=box(r['box'])
    if 'down_in' in t.get('roots',{}): t['roots']['down_in']['box']=box(t['roots']['down_in']['box'])
    if 'faces' in t: t['faces']='-Z' if t['faces']=='+Z' else '+Z'
    return t
def main(folder,out):
    truths=json.load(open(os.path.join(folder,'TRUTH.json'))); made={}
    for name,t in truths.items():
        if not t['hair']: continue
        base,file=name.split('/',1); ext=file.rsplit('.',1)[1].lower()
        def put(kind,write,truth,extension=None):
            d=os.path.join(out,base+'~'+kind); os.makedirs(d,exist_ok=True)
            f=file if kind in('turned','scaled','nobones') else 'model.'+(extension or ext)
            if ext=='vrm': f=f.rsplit('.',1)[0]+'.glb'
            write(os.path.join(d,f)); 
            for x in os.listdir(os.path.join(folder,base)):
                if x.endswith('.png'): shutil.copy(os.path.join(folder,base,x),d)
            made[base+'~'+kind+'/'+f]=truth
        if ext in('glb','vrm'):
            j,b=read_glb(os.path.join(folder,name))
            def variant(kind,edit,truth):
                k=copy.deepcopy(j); edit(k); put(kind,lambda p:write_glb(p,k,b),truth)
            variant('neutral',neutral,t)
            variant('nobones',neutral_bones,t)
            variant('nonames',lambda k:(neutral(k),neutral_bones(k)),t)
            if ext=='glb': variant('turned',turn,rotate_truth(t))
            if 'any_size' not in t: variant('scaled',lambda k:scale(k,100),t)
            names=t['select'].get('is') if isinstance(t.get('select',{}).get('is'),list) else None
            if names and not base.startswith(('kaykit','sophia')):
                mats={n.split('/',1)[1] for n in names}; meshes={n.split('/',1)[0] for n in names}
                hair=lambda node,mesh,mat: mat in mats and (node in meshes or mesh in meshes)
                if any(hair(n.get('name',''),j['meshes'][n['mesh']].get('name',''),j['materials'][p['material']]['name'] if 'material' in p else '') for n in j['nodes'] if 'mesh' in n for p in j['meshes'][n['mesh']]['primitives']):
                    variant('haironly',lambda k:keep_meshes(k,hair),t)
                    variant('haironly_nonames',lambda k:(keep_meshes(k,hair),neutral(k),neutral_bones(k)),t)
                    def loose(k):
                        keep_meshes(k,hair); drop_skin(k,b); neutral(k); neutral_bones(k)
                    if not j.get('skins'): variant('haironly_loose',loose,t)
        elif ext=='obj':
            lines=open(os.path.join(folder,name),errors='replace').read().splitlines()
            def turned(p):
                o=open(p,'w')
                for l in lines:
                    if l.startswith('v ') or l.startswith('vn '):
                        w=l.split(); o.write(' '.join([w[0],str(-float(w[1])),w[2],str(-float(w[3]))]+w[4:])+'\n')
                    else: o.write(l+'\n')
            put('turned',turned,rotate_truth(t))
            def scaled(p):
                o=open(p,'w')
                for l in lines:
                    if l.startswith('v '):
                        w=l.split(); o.write('v '+' '.join(str(float(x)*254/10) for x in w[1:4])+'\n')
                    else: o.write(l+'\n')
            put('scaled',scaled,t)
            def nouv(p):
                o=open(p,'w')
                for l in lines:
                    if l.startswith(('vt ','vn ','g ','o ','usemtl','mtllib')): continue
                    if l.startswith('f '): l='f '+' '.join(x.split('/')[0] for x in l.split()[1:])
                    o.write(l+'\n')
            put('nouv',nouv,t)
    json.dump(made,open(os.path.join(out,'TRUTH.json'),'w'))
    print(len(made),'variants')
main(*sys.argv[1:])
